#include "orchestrator/validation/published_figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "mill/base/text_file.h"
#include "mill/base/user_table.h"

namespace millwear::orchestrator {
namespace {

Quantity quantity_in(const UserTable& table, const UserRow& row, std::size_t column) {
  std::string keys;
  for (const QuantityName& name : quantity_names()) {
    if (name.key == row.fields[column]) return name.quantity;
    keys += fmt::format("{}`{}`", keys.empty() ? "" : ", ", name.key);
  }
  refuse_line(
      table.file, row.line,
      fmt::format("{} is no quantity; give one of {}", in_quotes(row.fields[column]), keys));
}

std::optional<double> optional_number(const UserTable& table, const UserRow& row,
                                      std::size_t column) {
  if (row.fields[column].empty()) return std::nullopt;
  return number_in(table, row, column, "a number, or nothing");
}

}  // namespace

std::vector<PublishedFigure> read_published_figures(const std::filesystem::path& file) {
  const UserTable table = user_table(read_text_file(file), file);
  const std::size_t quantity = needed_column(table, "quantity");
  const std::size_t value = needed_column(table, "value");
  const std::size_t error = needed_column(table, "error");
  const std::size_t length = needed_column(table, "mill_length_m");
  const std::size_t height = needed_column(table, "lifter_height_m");
  const std::size_t source = needed_column(table, "source");
  std::vector<PublishedFigure> figures;
  for (const UserRow& row : table.rows) {
    PublishedFigure figure{quantity_in(table, row, quantity),
                           {number_in(table, row, value, "a number")},
                           optional_number(table, row, length),
                           optional_number(table, row, height),
                           row.fields[source]};
    if (const auto known = optional_number(table, row, error)) figure.figure.error = *known;
    if (figure.quantity == Quantity::power && !figure.mill_length)
      refuse_line(file, row.line, "a power without `mill_length_m`; give the length of its mill");
    if (figure.quantity == Quantity::face_angle && !figure.lifter_height)
      refuse_line(file, row.line,
                  "a face angle without `lifter_height_m`; give the height of its worn lifter");
    if (figure.source.empty())
      refuse_line(file, row.line, "a figure without a source; say who published it, and where");
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace millwear::orchestrator
