#pragma once
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace millwear {

enum class KeyType { name, choice, file, real, integer, boolean, reals, names, points };

/// Allowed values of a number: from `low` to `high`, `low` itself left out where `above_low`.
struct KeyRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool above_low = false;

  [[nodiscard]] bool holds(double value) const;
  [[nodiscard]] std::string text() const;  ///< "above 0", "from 0.05 to 1"; empty for any number
};

enum class Presence {
  required,
  defaulted,  ///< `KeySpec::default_text` stands where it is missing
  optional,
};

/// One key of a case file: everything that is known about it, for reading and for the manual.
struct KeySpec {
  std::string_view table;
  std::string_view key;
  KeyType type;
  Presence presence;
  std::string_view default_text;  ///< as it would stand in the file
  KeyRange range;                 ///< of the number, or of each number of an array
  std::string_view choices;       ///< words allowed for a choice, separated by '|'
  std::string_view doc;           ///< what it means, with its unit
};

struct TableSpec {
  std::string_view name;  ///< empty for the keys before the first table
  bool repeats;           ///< [[name]]
  bool required;
  std::string_view doc;
};

/// Every table and every key, in the order of the manual.
[[nodiscard]] std::span<const TableSpec> case_tables();
[[nodiscard]] std::span<const KeySpec> case_keys();

/// The key of a table, or nullptr.
[[nodiscard]] const KeySpec* find_key(std::string_view table, std::string_view key);
[[nodiscard]] const TableSpec* find_table_spec(std::string_view table);

/// "[mill]", "[[charge.counts]]", or "the top of the file".
[[nodiscard]] std::string table_heading(const TableSpec& table);

/// The version of the case file format that this program reads and writes.
inline constexpr int case_format_version = 1;

}  // namespace millwear
