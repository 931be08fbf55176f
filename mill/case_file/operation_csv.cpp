#include "mill/case_file/operation_csv.h"

#include <fmt/format.h>

#include <array>
#include <map>

#include "mill/base/nearest_word.h"
#include "mill/base/text_file.h"
#include "mill/base/user_table.h"

namespace millwear {
namespace {

/// A column and the key of [[campaign.operation]] that it fills, with its unit in the key's.
struct Column {
  std::string_view name;
  std::string_view key;
  double unit;
};

constexpr double of_percent = 0.01;
constexpr double hours_of_a_day = 24.0;

constexpr std::array<Column, 23> columns{{
    {"from_hours", "from_hours", 1.0},
    {"from_h", "from_hours", 1.0},
    {"from_days", "from_hours", hours_of_a_day},
    {"to_hours", "to_hours", 1.0},
    {"to_h", "to_hours", 1.0},
    {"to_days", "to_hours", hours_of_a_day},
    {"from_lifter_height_m", "from_lifter_height_m", 1.0},
    {"from_lifter_height_mm", "from_lifter_height_m", 1e-3},
    {"speed_rpm", "speed_rpm", 1.0},
    {"critical_speed_fraction", "critical_speed_fraction", 1.0},
    {"speed_percent_of_critical", "critical_speed_fraction", of_percent},
    {"total_filling", "total_filling", 1.0},
    {"total_filling_percent", "total_filling", of_percent},
    {"ball_filling", "ball_filling", 1.0},
    {"ball_filling_percent", "ball_filling", of_percent},
    {"feed_rate_t_per_h", "feed_rate_t_per_h", 1.0},
    {"feed_t_per_h", "feed_rate_t_per_h", 1.0},
    {"feed_rate_kg_per_s", "feed_rate_t_per_h", 3.6},
    {"direction", "direction", 0.0},
    {"idle_hours", "idle_hours", 1.0},
    {"idle_h", "idle_hours", 1.0},
    {"idle_days", "idle_hours", hours_of_a_day},
    {"idle_minutes", "idle_hours", 1.0 / 60.0},
}};

const Column* column_called(std::string_view name) {
  for (const Column& column : columns)
    if (column.name == lower_case(name)) return &column;
  return nullptr;
}

std::vector<const Column*> columns_of(const UserTable& table) {
  std::vector<const Column*> found;
  std::map<std::string_view, std::string_view> column_of_key;
  for (const std::string& name : table.header.fields) {
    const Column* const column = column_called(name);
    if (column == nullptr) {
      std::vector<std::string_view> known;
      for (const Column& each : columns) known.push_back(each.name);
      const std::string near = nearest_word(name, known);
      refuse_line(
          table.file, table.header.line,
          fmt::format("no quantity and unit is called {}; {}the columns are {}", in_quotes(name),
                      near.empty() ? "" : fmt::format("did you mean `{}`? ", near),
                      operation_columns()));
    }
    const auto [other, is_new] = column_of_key.insert({column->key, column->name});
    if (!is_new)
      refuse_line(table.file, table.header.line,
                  fmt::format("the columns `{}` and `{}` give the same quantity; delete one",
                              other->second, column->name));
    found.push_back(column);
  }
  return found;
}

}  // namespace

std::string operation_columns() {
  std::string names;
  for (const Column& column : columns)
    names += fmt::format("{}`{}`", names.empty() ? "" : ", ", column.name);
  return names;
}

std::vector<CaseTable> read_operation_csv(const std::filesystem::path& file) {
  const UserTable table = user_table(read_text_file(file), file);
  if (table.header.line == 0 || table.rows.empty())
    refuse_line(file, 1,
                fmt::format("the table is empty; its first line names the columns (of {}), then a "
                            "change of operation a line",
                            operation_columns()));
  const auto columns_here = columns_of(table);
  std::vector<CaseTable> changes;
  for (const UserRow& row : table.rows) {
    CaseTable change{"campaign.operation", row.line, true, {}};
    for (std::size_t i = 0; i < row.fields.size(); ++i) {
      const auto& [name, key, unit] = *columns_here[i];
      if (row.fields[i].empty()) continue;
      CaseValue value{row.line, {}};
      if (unit > 0.0)
        value.data = unit * number_in(table, row, i, fmt::format("a number of `{}`", name));
      else
        value.data = row.fields[i];
      change.keys.emplace_back(key, std::move(value));
    }
    changes.push_back(std::move(change));
  }
  return changes;
}

}  // namespace millwear
