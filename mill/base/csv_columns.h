#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "mill/base/csv.h"

namespace millwear {

/// An angle [rad] that a table has in degrees.
template <class Row>
struct InDegrees {
  double Row::*member;
};

/// A column of a table: its name in the file, and the member of a row that stands there.
template <class Row>
struct CsvColumn {
  std::string_view name;
  std::string_view unit;
  std::variant<int Row::*, double Row::*, InDegrees<Row>> member;
};

/// The names of columns as the second line of a file has them.
template <class Row>
[[nodiscard]] std::string names_of(std::span<const CsvColumn<Row>> columns) {
  std::string names;
  for (const auto& column : columns) names.append(names.empty() ? "" : ",").append(column.name);
  return names;
}

/// The bytes of a table; the same rows always give the same bytes.
template <class Row>
[[nodiscard]] std::string csv_table(std::string_view name_and_version,
                                    std::span<const CsvColumn<Row>> columns,
                                    const std::vector<Row>& rows) {
  struct Text {
    const Row& row;
    std::string operator()(int Row::*member) const { return std::to_string(row.*member); }
    std::string operator()(double Row::*member) const { return csv_number(row.*member); }
    std::string operator()(InDegrees<Row> angle) const { return csv_degrees(row.*angle.member); }
  };
  std::string text = csv_head({name_and_version, names_of(columns)});
  for (const auto& row : rows) {
    for (const auto& column : columns) text.append(std::visit(Text{row}, column.member)) += ',';
    text.back() = '\n';
  }
  return text;
}

/// Reads such a table back. Throws DiskError or ResultRejected (file:line).
template <class Row>
[[nodiscard]] std::vector<Row> read_csv_table(const std::filesystem::path& path,
                                              std::string_view name_and_version,
                                              std::span<const CsvColumn<Row>> columns) {
  struct Take {
    Row& row;
    CsvFields& fields;
    void operator()(int Row::*member) { row.*member = fields.integer(); }
    void operator()(double Row::*member) { row.*member = fields.number(); }
    void operator()(InDegrees<Row> angle) { row.*angle.member = fields.degrees(); }
  };
  const std::string names = names_of(columns);
  std::vector<Row> rows;
  for (const auto& line : read_csv(path, {name_and_version, names})) {
    CsvFields fields(path, line);
    Row& row = rows.emplace_back();
    for (const auto& column : columns) std::visit(Take{row, fields}, column.member);
  }
  return rows;
}

}  // namespace millwear
