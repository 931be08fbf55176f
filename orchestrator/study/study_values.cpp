#include "orchestrator/study/study_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "mill/base/csv.h"
#include "mill/base/nearest_word.h"

namespace millwear::orchestrator {

void check_keys(const CaseTable& table, std::span<const std::string_view> known,
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

std::optional<bool> switch_in(const CaseTable& table, std::string_view key,
                              CaseProblems& problems) {
  const CaseValue* const value = table.find(key);
  if (value == nullptr) return std::nullopt;
  if (const auto* const on = std::get_if<bool>(&value->data)) return *on;
  problems.add(value->line, fmt::format("`{}` is true or false", key));
  return std::nullopt;
}

std::optional<double> number_of(const CaseValue& value) {
  if (const auto* const real = std::get_if<double>(&value.data)) return *real;
  if (const auto* const whole = std::get_if<std::int64_t>(&value.data))
    return static_cast<double>(*whole);
  return std::nullopt;
}

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

}  // namespace millwear::orchestrator
