#pragma once
#include <Eigen/Core>
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

/// An enum that a table has as words, in the order of its values.
template <class Row>
struct InWords {
  std::span<const std::string_view> words;
  std::size_t (*value)(const Row& row);
  void (*set)(Row& row, std::size_t value);
};

/// A column of a table: its name in the file, its unit, what it is, and what of a row stands there.
/// All that is said of the column follows from this: header, writer, reader, the report's data and
/// the table in docs/file_formats.md.
template <class Row>
struct CsvColumn {
  std::string_view name;
  std::string_view unit;   ///< "1" for a plain number, empty for words
  std::string_view doc;    ///< as in docs/file_formats.md
  std::string_view field;  ///< name in the report's data; empty where it has none
  std::variant<int Row::*, double Row::*, InDegrees<Row>, std::string Row::*,
               Eigen::VectorXd Row::*, InWords<Row>>
      member;
};

/// The names of columns as the second line of a file has them.
template <class Row>
[[nodiscard]] std::string names_of(std::span<const CsvColumn<Row>> columns) {
  std::string names;
  for (const auto& column : columns) names.append(names.empty() ? "" : ",").append(column.name);
  return names;
}

/// The table of columns of docs/file_formats.md.
template <class Row>
[[nodiscard]] std::string columns_page(std::span<const CsvColumn<Row>> columns) {
  std::string page = "| column | unit | what it is |\n|---|---|---|\n";
  for (const auto& column : columns) {
    page.append("| `").append(column.name).append("` | ").append(column.unit);
    page.append(column.unit.empty() ? "| " : " | ").append(column.doc).append(" |\n");
  }
  return page;
}

/// The lines of rows, without the head of the file.
template <class Row>
[[nodiscard]] std::string csv_lines(std::span<const CsvColumn<Row>> columns,
                                    const std::vector<Row>& rows) {
  struct Text {
    const Row& row;
    std::string operator()(int Row::*member) const { return std::to_string(row.*member); }
    std::string operator()(double Row::*member) const { return csv_number(row.*member); }
    std::string operator()(InDegrees<Row> angle) const { return csv_degrees(row.*angle.member); }
    std::string operator()(std::string Row::*member) const { return row.*member; }
    std::string operator()(Eigen::VectorXd Row::*member) const { return csv_lengths(row.*member); }
    std::string operator()(const InWords<Row>& choice) const {
      return std::string(choice.words[choice.value(row)]);
    }
  };
  std::string text;
  for (const auto& row : rows) {
    for (const auto& column : columns) text.append(std::visit(Text{row}, column.member)) += ',';
    text.back() = '\n';
  }
  return text;
}

/// The bytes of a table; the same rows always give the same bytes.
template <class Row>
[[nodiscard]] std::string csv_table(std::string_view name_and_version,
                                    std::span<const CsvColumn<Row>> columns,
                                    const std::vector<Row>& rows) {
  return csv_head({name_and_version, names_of(columns)}) + csv_lines(columns, rows);
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
    void operator()(std::string Row::*member) { row.*member = fields.text(); }
    void operator()(Eigen::VectorXd Row::*member) { row.*member = fields.lengths(); }
    void operator()(const InWords<Row>& choice) { choice.set(row, fields.one_of(choice.words)); }
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

/// The line of a file in which a row of its table stands, from 1.
[[nodiscard]] constexpr std::size_t line_of_row(std::size_t row) { return row + 3; }

}  // namespace millwear
