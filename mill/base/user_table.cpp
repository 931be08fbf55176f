#include "mill/base/user_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "mill/base/failure.h"
#include "mill/base/text_file.h"

namespace millwear {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields;
  for (std::size_t start = 0; start <= line.size();) {
    const std::size_t comma = std::min(line.find(',', start), line.size());
    fields.emplace_back(trimmed(line.substr(start, comma - start)));
    start = comma + 1;
  }
  return fields;
}

}  // namespace

void refuse_line(const std::filesystem::path& file, int line, std::string_view what) {
  throw InputError(fmt::format("{}:{}: {}", file.string(), line, what));
}

UserTable user_table(std::string_view text, const std::filesystem::path& file) {
  UserTable table{file, {0, {}}, {}};
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = trimmed(text.substr(0, std::min(end, text.find('#'))));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty()) {
      continue;
    }
    UserRow row{number, fields_of(line)};
    if (table.header.line == 0) {
      table.header = std::move(row);
      continue;
    }
    if (row.fields.size() != table.header.fields.size()) {
      refuse_line(file, number,
                  fmt::format("{} values where the header names {}; give one value a column",
                              row.fields.size(), table.header.fields.size()));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::optional<std::size_t> column_named(const UserTable& table, std::string_view name) {
  const auto& names = table.header.fields;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    return std::nullopt;
  }
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
  const std::string& text = row.fields.at(column);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    refuse_line(table.file, row.line,
                fmt::format("{} is not a number ({}); mend the value", in_quotes(text), such_as));
  }
  return value;
}

}  // namespace millwear
