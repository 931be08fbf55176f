#pragma once
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "mill/case_keys/case_document.h"
#include "mill/case_keys/case_key.h"

namespace millwear {

/// The number in a value that has passed the schema check, written whole or with a point.
[[nodiscard]] double number_in(const CaseValue& value);
[[nodiscard]] std::vector<double> numbers_in(const CaseValue& value);

/// A value as it stands in a case file: numbers in the shortest form that reads back the same.
[[nodiscard]] std::string file_text(double value);
[[nodiscard]] std::string file_text(const std::vector<double>& values);  ///< "[1, 2.5]"
[[nodiscard]] std::string file_text(std::string_view text);              ///< in quotes

template <std::same_as<std::filesystem::path> Path>
[[nodiscard]] std::string file_text(const Path& file) {
  return file_text(std::string_view(file.native()));
}

template <typename Whole>
requires std::is_integral_v<Whole>
[[nodiscard]] std::string file_text(Whole value) {
  if constexpr (std::is_same_v<Whole, bool>) {
    return value ? "true" : "false";
  } else {
    return std::to_string(value);
  }
}

/// The type of key that fills a member of type `Value`.
template <typename Value>
inline constexpr KeyType key_type = std::is_same_v<Value, double>                ? KeyType::real
                                    : std::is_same_v<Value, bool>                ? KeyType::boolean
                                    : std::is_integral_v<Value>                  ? KeyType::integer
                                    : std::is_same_v<Value, std::vector<double>> ? KeyType::reals
                                    : std::is_same_v<Value, std::filesystem::path> ? KeyType::file
                                                                                   : KeyType::name;

/// The value of a key that fills a member of type `Value`.
template <typename Value>
[[nodiscard]] Value value_in(const CaseValue& value) {
  if constexpr (std::is_same_v<Value, double>) {
    return number_in(value);
  } else if constexpr (std::is_same_v<Value, bool>) {
    return std::get<bool>(value.data);
  } else if constexpr (std::is_integral_v<Value>) {
    return static_cast<Value>(std::get<std::int64_t>(value.data));
  } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
    return numbers_in(value);
  } else {
    return std::get<std::string>(value.data);
  }
}

}  // namespace millwear
