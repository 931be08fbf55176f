#pragma once
#include <span>
#include <string>
#include <string_view>

#include "mill/case_keys/case_key.h"

namespace millwear {

struct TableSpec {
  std::string_view name;  ///< empty for the keys before the first table
  bool repeats;           ///< [[name]]
  bool required;
  std::string_view doc;
};

/// Every table and every key, in the order of the manual and of the locked copy.
[[nodiscard]] std::span<const TableSpec> case_tables();
[[nodiscard]] std::span<const KeySpec> case_keys();

/// The key of a table, or nullptr.
[[nodiscard]] const KeySpec* find_key(std::string_view table, std::string_view key);
[[nodiscard]] const TableSpec* find_table_spec(std::string_view table);

/// "[mill]", "[[charge.counts]]", or "the top of the file".
[[nodiscard]] std::string table_heading(const TableSpec& table);

}  // namespace millwear
