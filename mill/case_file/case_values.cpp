#include "mill/case_file/case_values.h"

#include <charconv>
#include <stdexcept>

#include "mill/case_keys/case_schema.h"
#include "mill/case_keys/key_value.h"

namespace millwear {
namespace {

[[noreturn]] void no_value(const CaseTable& table, std::string_view key) {
  throw std::logic_error("no value of the wanted type for " + table.name + "." + std::string(key));
}

std::string_view default_of(const CaseTable& table, std::string_view key) {
  const KeySpec* const spec = find_key(table.name, key);
  if (spec == nullptr || spec->presence != Presence::defaulted) {
    no_value(table, key);
  }
  return spec->default_text;
}

}  // namespace

std::optional<double> optional_real(const CaseTable& table, std::string_view key) {
  const CaseValue* const value = table.find(key);
  return value == nullptr ? std::nullopt : std::optional(number_in(*value));
}

std::optional<std::string> optional_text(const CaseTable& table, std::string_view key) {
  const CaseValue* const value = table.find(key);
  return value == nullptr ? std::nullopt : std::optional(std::get<std::string>(value->data));
}

double real_value(const CaseTable& table, std::string_view key) {
  if (const std::optional<double> value = optional_real(table, key)) {
    return *value;
  }
  const std::string_view text = default_of(table, key);
  double value = 0.0;
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc()) {
    no_value(table, key);
  }
  return value;
}

bool boolean_value(const CaseTable& table, std::string_view key) {
  const CaseValue* const value = table.find(key);
  return value == nullptr ? default_of(table, key) == "true" : std::get<bool>(value->data);
}

std::string text_value(const CaseTable& table, std::string_view key) {
  if (std::optional<std::string> value = optional_text(table, key)) {
    return *value;
  }
  const std::string_view quoted = default_of(table, key);
  return std::string(quoted.substr(1, quoted.size() - 2));
}

std::vector<double> real_values(const CaseTable& table, std::string_view key) {
  const CaseValue* const value = table.find(key);
  if (value == nullptr) {
    no_value(table, key);
  }
  return numbers_in(*value);
}

std::vector<std::string> text_values(const CaseTable& table, std::string_view key) {
  const CaseValue* const value = table.find(key);
  if (value == nullptr) {
    no_value(table, key);
  }
  std::vector<std::string> texts;
  for (const CaseValue& element : std::get<CaseArray>(value->data)) {
    texts.push_back(std::get<std::string>(element.data));
  }
  return texts;
}

std::vector<Eigen::Vector2d> point_values(const CaseTable& table, std::string_view key) {
  const CaseValue* const value = table.find(key);
  if (value == nullptr) {
    no_value(table, key);
  }
  std::vector<Eigen::Vector2d> points;
  for (const CaseValue& element : std::get<CaseArray>(value->data)) {
    const auto& pair = std::get<CaseArray>(element.data);
    points.emplace_back(number_in(pair[0]), number_in(pair[1]));
  }
  return points;
}

}  // namespace millwear
