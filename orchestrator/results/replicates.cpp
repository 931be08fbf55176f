#include "orchestrator/results/replicates.h"

#include <fmt/format.h>

#include <array>

#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

using Row = ReplicateRow;

constexpr std::string_view replicates_format = "millwear replicates 1";
constexpr std::array<CsvColumn<Row>, 5> columns{{
    {"cycle", "1", "as in `history.csv`", "", &Row::cycle},
    {"step", "1", "as in `history.csv`", "", &Row::step},
    {"operating_hours", "h", "since the liner was new", "", &Row::operating_hours},
    {"lifter_height_m", "m",
     "of every replicate, separated by spaces, to 0.001 mm; a replicate has the same place in "
     "every row",
     "", &Row::heights},
    {"plate_thickness_m", "m", "likewise, least steel over the shell", "", &Row::plates},
}};

}  // namespace

std::span<const CsvColumn<ReplicateRow>> replicate_columns() { return columns; }

std::string replicates_csv(const std::vector<ReplicateRow>& rows) {
  return csv_table(replicates_format, replicate_columns(), rows);
}

std::vector<ReplicateRow> read_replicates_csv(const std::filesystem::path& path) {
  const auto rows = read_csv_table(path, replicates_format, replicate_columns());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& heights = rows[i].heights;
    const auto& plates = rows[i].plates;
    const Eigen::Index count = rows.front().heights.size();
    if (heights.size() == 0 || heights.size() != count || plates.size() != count)
      throw ResultRejected(fmt::format(
          "{}:{}: {} lifter heights and {} plate thicknesses that are numbers, where {} of each "
          "should be; write it anew with `millwear report`",
          path.string(), line_of_row(i), heights.size(), plates.size(), count));
  }
  return rows;
}

}  // namespace millwear::orchestrator
