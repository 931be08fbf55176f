#include "mill/case_keys/key_value.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace millwear {

double number_in(const CaseValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value.data)) {
    return static_cast<double>(*whole);
  }
  return std::get<double>(value.data);
}

std::vector<double> numbers_in(const CaseValue& value) {
  std::vector<double> numbers;
  for (const CaseValue& element : std::get<CaseArray>(value.data)) {
    numbers.push_back(number_in(element));
  }
  return numbers;
}

std::string file_text(double value) { return fmt::format("{}", value); }

std::string file_text(const std::vector<double>& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

std::string file_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '"' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return fmt::format("\"{}\"", escaped);
}

}  // namespace millwear
