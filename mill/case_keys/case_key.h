#pragma once
#include <limits>
#include <string>
#include <string_view>

namespace millwear {

enum class KeyType { name, choice, file, words, real, integer, boolean, reals, names, points };

/// Allowed values of a number: from `low` to `high`, `low` itself left out where `above_low`.
struct KeyRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool above_low = false;

  [[nodiscard]] bool holds(double value) const;
  [[nodiscard]] std::string text() const;  ///< "above 0", "from 0.05 to 1"; empty for any number
};

inline constexpr KeyRange any_value{};
inline constexpr KeyRange positive{.low = 0.0, .above_low = true};
[[nodiscard]] constexpr KeyRange at_least(double low) { return {.low = low}; }
[[nodiscard]] constexpr KeyRange between(double low, double high) {
  return {.low = low, .high = high};
}
[[nodiscard]] constexpr KeyRange above_up_to(double low, double high) { return {low, high, true}; }

enum class Presence {
  required,
  defaulted,  ///< `KeySpec::default_text` stands where it is missing
  optional,
};

/// One key of a case file: everything that the schema check and the manual tell about it.
struct KeySpec {
  std::string_view table;
  std::string_view key;
  KeyType type;
  Presence presence;
  KeyRange range;              ///< of the number, or of each number of an array
  std::string_view doc;        ///< what it means, with its unit
  std::string default_text{};  ///< as it would stand in the file
  std::string choices{};       ///< words allowed for a choice, separated by '|'
};

}  // namespace millwear
