#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace millwear {

/// A row of a table that a user wrote, with the number of its line (from 1).
struct UserRow {
  int line;
  std::vector<std::string> fields;
};

/// A CSV that a user wrote: what follows a `#` is a comment, blank lines are skipped, the first
/// other line names the columns, and spaces around a field do not count.
struct UserTable {
  std::filesystem::path file;
  UserRow header;  ///< on line 0 where the file has none
  std::vector<UserRow> rows;
};

/// Throws InputError (file:line) for a row with another number of fields than the header.
[[nodiscard]] UserTable user_table(std::string_view text, const std::filesystem::path& file);

/// The column of that name; none if there is none.
[[nodiscard]] std::optional<std::size_t> column_named(const UserTable& table,
                                                      std::string_view name);

/// The same for a column that the table has to have. Throws InputError (file:line) if it has not.
[[nodiscard]] std::size_t needed_column(const UserTable& table, std::string_view name);

/// The number in a field. Throws InputError (file:line) for anything else; `such_as` says what
/// would be right: "metres, such as 0.215".
[[nodiscard]] double number_in(const UserTable& table, const UserRow& row, std::size_t column,
                               std::string_view such_as);

/// Throws InputError: "FILE:LINE: what".
[[noreturn]] void refuse_line(const std::filesystem::path& file, int line, std::string_view what);

}  // namespace millwear
