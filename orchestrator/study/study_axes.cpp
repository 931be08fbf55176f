#include "orchestrator/study/study_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "mill/base/failure.h"
#include "mill/base/text_file.h"
#include "mill/base/user_table.h"
#include "mill/case_file/case_edit.h"
#include "orchestrator/study/derived_axes.h"
#include "orchestrator/study/study_values.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<std::string_view, 5> axis_keys{"key", "values", "labels", "low", "high"};

void check_key(const std::string& key, int line, CaseProblems& problems) {
  if (is_derived_axis(key)) return;
  problems.attempt(line, [&] { static_cast<void>(case_key_path(key)); });
}

/// An interval, of which a Latin hypercube takes its values.
void read_interval(const CaseTable& table, StudyAxis& axis, CaseProblems& problems) {
  const auto number = [&table](std::string_view key) {
    const CaseValue* const value = table.find(key);
    return value != nullptr ? number_of(*value).value_or(nan) : nan;
  };
  axis.low = number("low");
  axis.high = number("high");
  if (axis.low < axis.high) return;
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

}  // namespace

StudyAxis axis_in(const CaseTable& table, AxisForm form, CaseProblems& problems) {
  check_keys(table, axis_keys, problems);
  StudyAxis axis{text_in(table, "key", problems).value_or(""), table.line, {}, {}};
  if (axis.key.empty()) {
    problems.add(table.line, "an axis has no `key`; name one of the case, such as \"mill.rows\"");
    return axis;
  }
  check_key(axis.key, table.find("key")->line, problems);
  if (form == AxisForm::interval)
    read_interval(table, axis, problems);
  else
    read_values(table, axis, problems);
  return axis;
}

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

}  // namespace millwear::orchestrator
