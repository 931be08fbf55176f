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

/// A table that a user, a gauge or a spreadsheet wrote:
/// - the first line that is not blank and no comment names the columns; a comment begins with `#`
///   anywhere, or with `%` or `//` at the start of a line;
/// - lines end with LF, CRLF or CR;
/// - the header's first of these separates the values: semicolon, tab, comma, blanks;
/// - values may stand in double quotes, spaces around them do not count, and empty values behind
///   the last column are left out;
/// - numbers have a decimal point, or all have a decimal comma.
struct UserTable {
  std::filesystem::path file;
  UserRow header;  ///< on line 0 where the file has none
  std::vector<UserRow> rows;
  char decimal = '.';  ///< or ','
};

/// Throws InputError (file:line) for a row with another number of fields than the header, a quote
/// that does not end, and decimal points and commas in one table.
[[nodiscard]] UserTable user_table(std::string_view text, const std::filesystem::path& file);

/// The column of that name, in upper or lower case; none if there is none.
[[nodiscard]] std::optional<std::size_t> column_named(const UserTable& table,
                                                      std::string_view name);

/// The same for a column that the table has to have. Throws InputError (file:line) if it has not.
[[nodiscard]] std::size_t needed_column(const UserTable& table, std::string_view name);

/// The number in a field, which may have a plus sign. Throws InputError (file:line) for anything
/// else; `such_as` says what would be right: "metres, such as 0.215".
[[nodiscard]] double number_in(const UserTable& table, const UserRow& row, std::size_t column,
                               std::string_view such_as);

/// Throws InputError: "FILE:LINE: what".
[[noreturn]] void refuse_line(const std::filesystem::path& file, int line, std::string_view what);

/// ASCII letters in lower case.
[[nodiscard]] std::string lower_case(std::string_view text);

}  // namespace millwear
