#include "orchestrator/study/study_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>

#include "mill/base/csv.h"
#include "mill/base/failure.h"
#include "mill/base/nearest_word.h"
#include "mill/base/text_file.h"
#include "mill/base/user_table.h"
#include "mill/case_file/case_edit.h"
#include "mill/case_file/case_file.h"
#include "mill/case_file/case_problems.h"
#include "orchestrator/study/derived_axes.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> combinations{"product", "zip", "latin_hypercube", "table",
                                                       "search"};
constexpr std::array<std::string_view, 10> top_keys{
    "format_version", "name",          "case", "replicates", "combine",
    "samples",        "budget_points", "seed", "table",      "axes"};
constexpr std::array<std::string_view, 5> axis_keys{"key", "values", "labels", "low", "high"};
constexpr std::array<std::string_view, 2> objective_keys{"maximise", "minimise"};
constexpr std::int64_t most_replicates = 1000;
constexpr std::int64_t most_samples = 1000000;

/// Adds a problem for every key of a table that is none of `known`.
template <std::size_t N>
void check_keys(const CaseTable& table, const std::array<std::string_view, N>& known,
                CaseProblems& problems) {
  const std::vector<std::string_view> words(known.begin(), known.end());
  for (const auto& [key, value] : table.keys) {
    if (std::ranges::find(known, key) != known.end()) continue;
    const std::string near = nearest_word(key, words);
    problems.add(value.line,
                 fmt::format("a study file has no key `{}`{}; {}", key,
                             table.name.empty() ? "" : " in [[" + table.name + "]]",
                             near.empty() ? "delete it" : fmt::format("did you mean `{}`?", near)));
  }
}

std::optional<std::string> text_in(const CaseTable& table, std::string_view key,
                                   CaseProblems& problems) {
  const CaseValue* const value = table.find(key);
  if (value == nullptr) return std::nullopt;
  if (const auto* const text = std::get_if<std::string>(&value->data)) return *text;
  problems.add(value->line, fmt::format("`{}` is not a text; put it in quotes", key));
  return std::nullopt;
}

std::optional<std::int64_t> whole_in(const CaseTable& table, std::string_view key,
                                     std::int64_t least, std::int64_t most,
                                     CaseProblems& problems) {
  const CaseValue* const value = table.find(key);
  if (value == nullptr) return std::nullopt;
  const auto* const number = std::get_if<std::int64_t>(&value->data);
  if (number != nullptr && *number >= least && *number <= most) return *number;
  problems.add(value->line, fmt::format("`{}` is a whole number from {} to {}", key, least, most));
  return std::nullopt;
}

std::optional<double> number_of(const CaseValue& value) {
  if (const auto* const real = std::get_if<double>(&value.data)) return *real;
  if (const auto* const whole = std::get_if<std::int64_t>(&value.data))
    return static_cast<double>(*whole);
  return std::nullopt;
}

void check_key(const std::string& key, int line, CaseProblems& problems) {
  if (is_derived_axis(key)) return;
  problems.attempt(line, [&] { static_cast<void>(case_key_path(key)); });
}

/// An interval, of which a Latin hypercube takes its values.
void read_interval(const CaseTable& table, StudyAxis& axis, CaseProblems& problems) {
  const CaseValue* const low = table.find("low");
  const CaseValue* const high = table.find("high");
  const auto low_number = low != nullptr ? number_of(*low) : std::nullopt;
  const auto high_number = high != nullptr ? number_of(*high) : std::nullopt;
  if (low_number && high_number && *low_number < *high_number) {
    axis.low = *low_number;
    axis.high = *high_number;
    return;
  }
  problems.add(table.line, fmt::format("the axis `{}` of a latin_hypercube or a search needs "
                                       "numbers `low` < `high`",
                                       axis.key));
}

void read_values(const CaseTable& table, StudyAxis& axis, CaseProblems& problems) {
  const CaseValue* const values = table.find("values");
  const auto* const list = values != nullptr ? std::get_if<CaseArray>(&values->data) : nullptr;
  if (list == nullptr || list->empty()) {
    problems.add(table.line, fmt::format("the axis `{}` has no `values`; list at least one in "
                                         "square brackets",
                                         axis.key));
    return;
  }
  axis.values = *list;
  for (const CaseValue& value : *list) {
    if (const auto* const foreign = std::get_if<ForeignValue>(&value.data))
      problems.add(value.line, fmt::format("a value of `{}` is {}; a case file takes none",
                                           axis.key, foreign->type));
    axis.labels.push_back(label_of(value));
  }
  if (const CaseValue* const labels = table.find("labels")) {
    const auto* const names = std::get_if<CaseArray>(&labels->data);
    if (names == nullptr || names->size() != axis.values.size()) {
      problems.add(labels->line,
                   fmt::format("`labels` names every one of the {} values", axis.values.size()));
      return;
    }
    for (std::size_t i = 0; i < names->size(); ++i) axis.labels[i] = label_of((*names)[i]);
  }
  auto sorted = axis.labels;
  std::ranges::sort(sorted);
  if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
    problems.add(table.line,
                 fmt::format("the axis `{}` has the value {} twice; delete one", axis.key, *twice));
}

StudyAxis axis_in(const CaseTable& table, Combine combine, CaseProblems& problems) {
  check_keys(table, axis_keys, problems);
  StudyAxis axis{text_in(table, "key", problems).value_or(""), table.line, {}, {}};
  if (axis.key.empty()) {
    problems.add(table.line, "an axis has no `key`; name one of the case, such as \"mill.rows\"");
    return axis;
  }
  check_key(axis.key, table.find("key")->line, problems);
  if (combine == Combine::latin_hypercube || combine == Combine::search)
    read_interval(table, axis, problems);
  else
    read_values(table, axis, problems);
  return axis;
}

std::vector<Limit> limits_in(const CaseDocument& document, CaseProblems& problems) {
  std::vector<Limit> limits;
  for (const auto& [name, kind] :
       {std::pair{"at_least", Limit::Kind::at_least}, std::pair{"at_most", Limit::Kind::at_most}})
    if (const CaseTable* const table = document.find(name))
      for (const auto& [key, value] : table->keys) {
        if (const auto number = number_of(value))
          limits.push_back({kind, key, *number});
        else
          problems.add(value.line, fmt::format("the limit of `{}` is not a number", key));
      }
  return limits;
}

void check_search(const Study& study, CaseProblems& problems) {
  if (study.combine != Combine::search) {
    if (!study.limits.empty())
      problems.add(1, "`at_least` and `at_most` are for `combine` = \"search\"; take them out");
    return;
  }
  if (study.samples == 0)
    problems.add(1, "a search needs `budget_points`, the number of points that it may try");
  if (!study.objective)
    problems.add(1, "a search needs an `objective`, such as { maximise = \"life_hours\" }");
}

/// The axes of a table of points: its header names keys, its rows are points.
std::vector<StudyAxis> axes_of_table(const fs::path& file, CaseProblems& problems) {
  const UserTable table = user_table(read_text_file(file, 16 << 20), file);
  std::vector<StudyAxis> axes;
  for (std::size_t column = 0; column < table.header.fields.size(); ++column) {
    StudyAxis axis{table.header.fields[column], table.header.line, {}, {}};
    check_key(axis.key, axis.line, problems);
    for (const UserRow& row : table.rows) {
      axis.values.push_back(value_from_text(row.fields[column], row.line));
      axis.labels.push_back(label_of(axis.values.back()));
    }
    if (axis.values.empty())
      problems.add(1, fmt::format("{} has no row; give a row for every point", file.string()));
    axes.push_back(std::move(axis));
  }
  return axes;
}

/// "life_hours" or "life_hours / power_w"
Objective ratio(Objective::Sense sense, std::string words) {
  std::erase(words, ' ');
  const auto slash = words.find('/');
  return {sense, words.substr(0, slash), slash == std::string::npos ? "" : words.substr(slash + 1)};
}

std::optional<Objective> objective_in(const CaseDocument& document, CaseProblems& problems) {
  const CaseTable* const table = document.find("objective");
  if (table == nullptr) return std::nullopt;
  check_keys(*table, objective_keys, problems);
  const auto most = text_in(*table, "maximise", problems);
  const auto least = text_in(*table, "minimise", problems);
  if (most.has_value() == least.has_value()) {
    problems.add(table->line,
                 "`objective` is one of { maximise = \"...\" } and { minimise = \"...\" }");
    return std::nullopt;
  }
  return ratio(most ? Objective::Sense::maximise : Objective::Sense::minimise,
               most ? *most : *least);
}

/// An axis `dem.seed` makes replicates, and no points.
void take_seeds(Study& study, CaseProblems& problems) {
  const auto axis = std::ranges::find(study.axes, "dem.seed", &StudyAxis::key);
  if (axis == study.axes.end()) return;
  for (const CaseValue& value : axis->values) {
    const auto* const seed = std::get_if<std::int64_t>(&value.data);
    if (seed == nullptr || *seed < 1 || *seed > std::numeric_limits<int>::max())
      problems.add(
          value.line,
          fmt::format("`dem.seed` = {} is no seed; it is a whole number from 1", label_of(value)));
    else
      study.seeds.push_back(static_cast<std::uint64_t>(*seed));
  }
  study.replicates = static_cast<int>(study.seeds.size());
  study.axes.erase(axis);
}

void check_axes(const Study& study, CaseProblems& problems) {
  if (study.axes.empty() && study.seeds.empty())
    problems.add(1, "the study varies nothing; give it an [[axes]] with `key` and `values`");
  for (std::size_t i = 0; i < study.axes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (!study.axes[i].key.empty() && study.axes[i].key == study.axes[k].key)
        problems.add(study.axes[i].line,
                     fmt::format("two axes vary `{}` (the other is on line {}); give its values in "
                                 "one",
                                 study.axes[i].key, study.axes[k].line));
  if (study.combine != Combine::zip) return;
  for (const StudyAxis& axis : study.axes)
    if (axis.values.size() != study.axes.front().values.size())
      problems.add(axis.line, fmt::format("`{}` has {} values and `{}` has {}; zip takes as many "
                                          "of each",
                                          axis.key, axis.values.size(), study.axes.front().key,
                                          study.axes.front().values.size()));
}

Combine combine_in(const CaseTable& top, CaseProblems& problems) {
  const std::string word = text_in(top, "combine", problems)
                               .value_or(top.find("table") != nullptr ? "table" : "product");
  const auto found = std::ranges::find(combinations, word);
  if (found != combinations.end()) return static_cast<Combine>(found - combinations.begin());
  problems.add(
      top.find("combine")->line,
      fmt::format("`combine` = \"{}\" is none of product, zip, latin_hypercube, table and search",
                  word));
  return Combine::product;
}

/// The numbers of LOW:HIGH:STEP.
std::vector<CaseValue> range_of(const std::string& text, const std::string& axis) {
  const auto first = text.find(':');
  const auto second = text.find(':', first + 1);
  const auto low = number_of(value_from_text(text.substr(0, first), 1));
  const auto high = number_of(value_from_text(text.substr(first + 1, second - first - 1), 1));
  const auto step = second == std::string::npos
                        ? std::optional(1.0)
                        : number_of(value_from_text(text.substr(second + 1), 1));
  if (!low || !high || !step || *step <= 0.0 || *high < *low)
    throw InputError(fmt::format("--axis {}: {} is no range; write LOW:HIGH:STEP", axis, text));
  std::vector<CaseValue> values;
  const auto count = static_cast<long>(std::floor((*high - *low) / *step + 1e-9));
  for (long i = 0; i <= count; ++i) {
    const double number = *low + static_cast<double>(i) * *step;
    values.push_back(value_from_text(fmt::format("{:.10g}", number), 1));
  }
  return values;
}

StudyAxis axis_from_words(const std::string& words) {
  const auto equals = words.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == words.size())
    throw InputError(fmt::format("--axis {}: write KEY=VALUE,VALUE or KEY=LOW:HIGH:STEP", words));
  StudyAxis axis{words.substr(0, equals), 1, {}, {}};
  if (!is_derived_axis(axis.key)) static_cast<void>(case_key_path(axis.key));
  std::string rest = words.substr(equals + 1) + ",";
  for (std::size_t comma; (comma = rest.find(',')) != std::string::npos; rest.erase(0, comma + 1)) {
    const std::string text = rest.substr(0, comma);
    if (text.find(':') != std::string::npos)
      std::ranges::copy(range_of(text, words), std::back_inserter(axis.values));
    else
      axis.values.push_back(value_from_text(text, 1));
  }
  for (const CaseValue& value : axis.values) axis.labels.push_back(label_of(value));
  return axis;
}

}  // namespace

std::string label_of(const CaseValue& value) {
  struct Label {
    std::string operator()(ForeignValue foreign) const { return std::string(foreign.type); }
    std::string operator()(bool is) const { return is ? "true" : "false"; }
    std::string operator()(std::int64_t number) const { return std::to_string(number); }
    std::string operator()(double number) const { return csv_number(number); }
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(const CaseArray& values) const {
      std::string text;
      for (const CaseValue& one : values) text += (text.empty() ? "" : " ") + label_of(one);
      return text;
    }
  };
  return std::visit(Label{}, value.data);
}

Study read_study(const fs::path& file) {
  const CaseDocument document = read_case_document(file);
  CaseProblems problems(file);
  const CaseTable& top = *document.find("");
  check_keys(top, top_keys, problems);
  if (whole_in(top, "format_version", 1, 1, problems) == std::nullopt && problems.empty())
    problems.add(1, "`format_version` is missing; this program reads format_version = 1");
  Study study{file, text_in(top, "name", problems).value_or(file.stem().string()), {}};
  if (const auto base = text_in(top, "case", problems))
    study.case_file = file.parent_path() / *base;
  else
    problems.add(1, "the study has no `case`; name the case file that its points start from");
  study.combine = combine_in(top, problems);
  study.replicates =
      static_cast<int>(whole_in(top, "replicates", 1, most_replicates, problems).value_or(1));
  study.seed = static_cast<std::uint64_t>(
      whole_in(top, "seed", 1, std::numeric_limits<int>::max(), problems).value_or(1));
  const char* const count = study.combine == Combine::search ? "budget_points" : "samples";
  study.samples = static_cast<int>(whole_in(top, count, 1, most_samples, problems).value_or(0));
  if (study.combine == Combine::latin_hypercube && study.samples == 0)
    problems.add(1, "a latin_hypercube needs `samples`, the number of its points");
  study.objective = objective_in(document, problems);
  if (const auto table = text_in(top, "table", problems)) {
    study.axes = axes_of_table(file.parent_path() / *table, problems);
  } else {
    for (const CaseTable* const axis : document.all("axes"))
      study.axes.push_back(axis_in(*axis, study.combine, problems));
  }
  if (study.combine == Combine::product) take_seeds(study, problems);
  check_axes(study, problems);
  study.limits = limits_in(document, problems);
  check_search(study, problems);
  problems.throw_if_any();
  return study;
}

Study study_of_case(const fs::path& case_file, const std::vector<std::string>& axes) {
  Study study{case_file, "study", case_file};
  for (const std::string& words : axes) study.axes.push_back(axis_from_words(words));
  CaseProblems problems(case_file);
  take_seeds(study, problems);
  check_axes(study, problems);
  problems.throw_if_any();
  return study;
}

Objective objective_from(const std::string& words) {
  const auto blank = words.find(' ');
  const std::string sense = words.substr(0, blank);
  if (blank == std::string::npos || (sense != "maximise" && sense != "minimise"))
    throw InputError(fmt::format(
        "--objective {}: write \"maximise COLUMN\" or \"minimise COLUMN / COLUMN\"", words));
  return ratio(sense == "maximise" ? Objective::Sense::maximise : Objective::Sense::minimise,
               words.substr(blank));
}

std::string spoken(const Objective& objective) {
  return fmt::format("{} {}{}",
                     objective.sense == Objective::Sense::maximise ? "maximise" : "minimise",
                     objective.result, objective.divisor.empty() ? "" : " / " + objective.divisor);
}

}  // namespace millwear::orchestrator
