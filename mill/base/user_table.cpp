#include "mill/base/user_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "mill/base/failure.h"
#include "mill/base/number_text.h"
#include "mill/base/text_file.h"

namespace millwear {
namespace {

/// As a separator: any number of spaces and tabs.
constexpr char blanks = ' ';

/// Takes the next line from `text`, without what ends it.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  const bool two = text.substr(end).starts_with("\r\n");
  text.remove_prefix(std::min(end + (two ? 2 : 1), text.size()));
  return line;
}

/// Calls `visit(character, place)` for what stands outside of quotes, until it returns true.
template <class Visit>
std::size_t find_unquoted(std::string_view line, Visit visit) {
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') is_quoted = !is_quoted;
    if (!is_quoted && visit(line[i])) return i;
  }
  return line.size();
}

std::string_view without_comment(std::string_view line) {
  const std::string_view content = trimmed(line);
  if (content.starts_with('%') || content.starts_with("//")) return {};
  return trimmed(line.substr(0, find_unquoted(line, [](char c) { return c == '#'; })));
}

char separator_of(std::string_view header) {
  for (const char separator : {';', '\t', ','})
    if (find_unquoted(header, [&](char c) { return c == separator; }) < header.size())
      return separator;
  return find_unquoted(header, [](char c) { return c == ' '; }) < header.size() ? blanks : ',';
}

/// A value without its quotes; two quotes in a row are one.
std::string unquoted(std::string_view value) {
  value = trimmed(value);
  if (value.size() < 2 || value.front() != '"' || value.back() != '"') return std::string(value);
  std::string text;
  for (std::size_t i = 1; i + 1 < value.size(); ++i) {
    text += value[i];
    if (value[i] == '"' && value[i + 1] == '"') ++i;
  }
  return std::string(trimmed(text));
}

std::vector<std::string> fields_of(std::string_view line, char separator) {
  std::vector<std::string> fields;
  for (;;) {
    const std::size_t end = find_unquoted(
        line, [&](char c) { return c == separator || (separator == blanks && c == '\t'); });
    fields.push_back(unquoted(line.substr(0, end)));
    if (end == line.size()) return fields;
    line.remove_prefix(end + 1);
    if (separator == blanks) line = trimmed(line);
  }
}

/// "x [mm] y [mm]" separated by blanks has its units apart from their columns.
void join_units(std::vector<std::string>& names) {
  for (std::size_t i = 1; i < names.size();) {
    if (names[i].starts_with('[') || names[i].starts_with('(')) {
      names[i - 1] += " " + names[i];
      names.erase(names.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
}

void drop_empty_end(std::vector<std::string>& fields, std::size_t least) {
  while (fields.size() > least && fields.back().empty()) fields.pop_back();
}

/// The decimal sign of a field that is a number with one; else 0.
char decimal_sign(std::string_view field) {
  if (field.starts_with('+') || field.starts_with('-')) field.remove_prefix(1);
  char sign = 0;
  std::size_t digits = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const char c = field[i];
    if (c >= '0' && c <= '9') {
      ++digits;
    } else if ((c == '.' || c == ',') && sign == 0) {
      sign = c;
    } else if ((c == 'e' || c == 'E') && digits > 0) {
      break;
    } else {
      return 0;
    }
  }
  return digits > 0 ? sign : '\0';
}

/// The decimal sign of all numbers of the table. Refuses one that has both.
void find_decimal(UserTable& table) {
  int line = 0;
  for (const UserRow& row : table.rows) {
    for (const std::string& field : row.fields) {
      const char sign = decimal_sign(field);
      if (sign == 0) continue;
      if (line > 0 && sign != table.decimal)
        refuse_line(table.file, row.line,
                    fmt::format("{} has a decimal {} and line {} has a decimal {}; write all "
                                "numbers alike",
                                in_quotes(field), sign == ',' ? "comma" : "point", line,
                                sign == ',' ? "point" : "comma"));
      if (line == 0) line = row.line;
      table.decimal = sign;
    }
  }
}

void check_quotes(const std::filesystem::path& file, int number, std::string_view line) {
  if (std::ranges::count(line, '"') % 2 != 0)
    refuse_line(file, number, "a quote (\") does not end on its line; add the missing one");
}

void check_width(const UserTable& table, const UserRow& row, char separator) {
  const std::size_t found = row.fields.size();
  const std::size_t named = table.header.fields.size();
  if (found == named) return;
  refuse_line(
      table.file, row.line,
      fmt::format("{} values where the header names {}; give one value a column{}", found, named,
                  separator == ',' && found == 2 * named
                      ? " (numbers with a decimal comma need `;` or tabs between them)"
                      : ""));
}

}  // namespace

void refuse_line(const std::filesystem::path& file, int line, std::string_view what) {
  throw InputError(fmt::format("{}:{}: {}", file.string(), line, what));
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

UserTable user_table(std::string_view text, const std::filesystem::path& file) {
  UserTable table{file, {0, {}}, {}};
  char separator = ',';
  for (int number = 1; !text.empty(); ++number) {
    const std::string_view line = without_comment(take_line(text));
    if (line.empty()) continue;
    check_quotes(file, number, line);
    if (table.header.line == 0) {
      separator = separator_of(line);
      table.header = {number, fields_of(line, separator)};
      if (separator == blanks) join_units(table.header.fields);
      drop_empty_end(table.header.fields, 1);
      continue;
    }
    UserRow row{number, fields_of(line, separator)};
    drop_empty_end(row.fields, table.header.fields.size());
    check_width(table, row, separator);
    table.rows.push_back(std::move(row));
  }
  find_decimal(table);
  return table;
}

std::optional<std::size_t> column_named(const UserTable& table, std::string_view name) {
  const auto& names = table.header.fields;
  const auto found = std::ranges::find_if(
      names, [&](const std::string& each) { return lower_case(each) == lower_case(name); });
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

std::size_t needed_column(const UserTable& table, std::string_view name) {
  if (table.header.line == 0) {
    refuse_line(
        table.file, 1,
        fmt::format("the table is empty; its first line names the columns, among them `{}`", name));
  }
  const auto found = column_named(table, name);
  if (!found) {
    refuse_line(
        table.file, table.header.line,
        fmt::format("no column `{}` among {}; add it", name, fmt::join(table.header.fields, ", ")));
  }
  return *found;
}

double number_in(const UserTable& table, const UserRow& row, std::size_t column,
                 std::string_view such_as) {
  const std::string& field = row.fields.at(column);
  std::string text = field;
  if (table.decimal == ',') std::ranges::replace(text, ',', '.');
  const auto value = number_of(text);
  if (!value)
    refuse_line(table.file, row.line,
                fmt::format("{} is not a number ({}); mend the value", in_quotes(field), such_as));
  return *value;
}

}  // namespace millwear
