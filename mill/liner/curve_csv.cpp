#include "mill/liner/curve_csv.h"

#include <fmt/format.h>

#include <algorithm>

#include "mill/base/text_file.h"
#include "mill/base/user_table.h"

namespace millwear {
namespace {

/// How the first line of a profile reads that the program wrote.
constexpr std::string_view own_mark = "# millwear profile ";

/// A column of lengths, such as `x [mm]`.
struct LengthColumn {
  std::size_t index;
  std::optional<LengthUnit> unit;
};

struct LengthName {
  std::string quantity;
  std::optional<LengthUnit> unit;
  bool is_known;  ///< the unit that is named, if one is
};

/// "eta [mm]", "ETA_mm", "eta (mm)", "eta mm", "eta/mm" and "eta" as quantity and unit.
LengthName length_name(std::string_view column) {
  std::string text = lower_case(column);
  for (char& c : text)
    if (c == '[' || c == ']' || c == '(' || c == ')' || c == '_' || c == '/') c = ' ';
  const std::size_t end = text.find(' ');
  if (end == std::string::npos) return {text, std::nullopt, true};
  const std::size_t from = text.find_first_not_of(' ', end);
  if (from == std::string::npos) return {text.substr(0, end), std::nullopt, true};
  const std::string word = text.substr(from, text.find_last_not_of(' ') - from + 1);
  const auto unit = length_unit_called(word);
  return {text.substr(0, end), unit, unit.has_value()};
}

std::optional<LengthColumn> column_of(const UserTable& table, std::string_view quantity) {
  for (std::size_t i = 0; i < table.header.fields.size(); ++i) {
    const LengthName name = length_name(table.header.fields[i]);
    if (name.quantity != quantity) continue;
    if (!name.is_known)
      refuse_line(table.file, table.header.line,
                  fmt::format("{} names no unit of length; use m, mm, cm, in or ft",
                              in_quotes(table.header.fields[i])));
    return LengthColumn{i, name.unit};
  }
  return std::nullopt;
}

/// Metres in the unit of a column. `said` is the user's word, in place of one in the file.
double metres_per_unit(const UserTable& table, const LengthColumn& column, CurveFrame frame,
                       std::optional<LengthUnit> said) {
  const std::string name = in_quotes(table.header.fields[column.index]);
  if (column.unit && said && *column.unit != *said)
    refuse_line(table.file, table.header.line,
                fmt::format("{} is in {} and --unit says {}; leave one out", name,
                            name_of(*column.unit).symbol, name_of(*said).symbol));
  if (!column.unit && !said && frame == CurveFrame::master)
    refuse_line(table.file, table.header.line,
                fmt::format("{} does not say its unit; write it like `xi_m` or `xi [mm]`", name));
  return name_of(column.unit.value_or(said.value_or(LengthUnit::metre))).metres;
}

bool is_own(std::string_view text) { return text.starts_with(own_mark); }

void check_is_not_cut_off(std::string_view text, const std::filesystem::path& file) {
  if (!is_own(text) || text.ends_with('\n')) return;
  refuse_line(file, 1 + static_cast<int>(std::ranges::count(text, '\n')),
              "the last line does not end, so the file is cut off; copy it again");
}

std::size_t decimals_of(const UserTable& table, const std::string& number) {
  const std::size_t sign = number.find(table.decimal);
  return sign == std::string::npos ? 0 : number.size() - sign - 1;
}

/// Half of a number is a number. So where the last line does not end, its last number must have as
/// many decimals as one of the others.
void check_last_number_is_whole(std::string_view text, const UserTable& table) {
  constexpr std::size_t rows_that_tell = 3;
  if (text.ends_with('\n') || text.ends_with('\r') || table.rows.size() <= rows_that_tell) return;
  const UserRow& last = table.rows.back();
  const std::size_t decimals = decimals_of(table, last.fields.back());
  const bool all_have_more = std::ranges::all_of(
      table.rows.begin(), table.rows.end() - 1,
      [&](const UserRow& row) { return decimals_of(table, row.fields.back()) > decimals; });
  if (all_have_more)
    refuse_line(table.file, last.line,
                fmt::format("{} has fewer decimals than all before it, and its line does not end, "
                            "so the file is cut off; copy it again",
                            in_quotes(last.fields.back())));
}

}  // namespace

CurveRows curve_rows(std::string_view text, const std::filesystem::path& file,
                     std::optional<LengthUnit> unit) {
  check_is_not_cut_off(text, file);
  const UserTable table = user_table(text, file);
  if (table.header.line == 0)
    refuse_line(file, 1,
                "the table is empty; its first line is `x,y` or `xi_m,eta_m`, then a point a line");
  auto across = column_of(table, "xi");
  auto up = column_of(table, "eta");
  const CurveFrame frame = across && up ? CurveFrame::master : CurveFrame::own;
  if (frame == CurveFrame::own) {
    across = column_of(table, "x");
    up = column_of(table, "y");
  }
  if (!across || !up)
    refuse_line(file, table.header.line,
                "the header names neither `xi_m` and `eta_m` (the master frame, in metres) nor `x` "
                "and `y`; it reads `x,y`, then a point a line");
  if (across->unit.has_value() != up->unit.has_value())
    refuse_line(file, table.header.line,
                fmt::format("of {} and {} one names its unit; name that of both",
                            in_quotes(table.header.fields[across->index]),
                            in_quotes(table.header.fields[up->index])));
  const double across_scale = metres_per_unit(table, *across, frame, unit);
  const double up_scale = metres_per_unit(table, *up, frame, unit);
  check_last_number_is_whole(text, table);
  CurveRows curve{frame, {}, {}, is_own(text)};
  constexpr std::string_view length = "a length, such as 0.215";
  for (const UserRow& row : table.rows) {
    curve.nodes.emplace_back(across_scale * number_in(table, row, across->index, length),
                             up_scale * number_in(table, row, up->index, length));
    curve.lines.push_back(row.line);
  }
  return curve;
}

}  // namespace millwear
