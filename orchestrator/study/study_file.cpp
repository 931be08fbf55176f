#include "orchestrator/study/study_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "mill/base/failure.h"
#include "mill/case_file/case_file.h"
#include "mill/case_file/case_problems.h"
#include "orchestrator/study/study_values.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> combinations{"product", "zip", "latin_hypercube", "table",
                                                       "search"};
constexpr std::array<std::string_view, 11> top_keys{
    "format_version", "name", "case",  "replicates", "combine",         "samples",
    "budget_points",  "seed", "table", "axes",       "charge_from_base"};
constexpr std::array<std::string_view, 2> objective_keys{"maximise", "minimise"};
constexpr std::int64_t most_replicates = 1000;
constexpr std::int64_t most_samples = 1000000;

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

}  // namespace

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
    const AxisForm form =
        study.combine == Combine::latin_hypercube || study.combine == Combine::search
            ? AxisForm::interval
            : AxisForm::values;
    for (const CaseTable* const axis : document.all("axes"))
      study.axes.push_back(axis_in(*axis, form, problems));
  }
  if (study.combine == Combine::product) take_seeds(study, problems);
  check_axes(study, problems);
  study.limits = limits_in(document, problems);
  study.charge_from_base = switch_in(top, "charge_from_base", problems).value_or(false);
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
