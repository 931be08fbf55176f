#include "orchestrator/results/profiles.h"

#include <fmt/format.h>

#include <array>

#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

using Row = ProfileNodeRow;

constexpr std::string_view profiles_format = "millwear profiles 2";
constexpr std::array<CsvColumn<Row>, 7> columns{{
    {"cycle", "1", "as in `history.csv`", "", &Row::cycle},
    {"step", "1", "as in `history.csv`", "", &Row::step},
    {"operating_hours", "h", "since the liner was new", "", &Row::operating_hours},
    {"node", "1", "0, 1, 2, … from the trailing sector edge to the leading one", "", &Row::node},
    {"xi_m", "m", "along the direction of rotation when the liner was new", "", &Row::xi},
    {"eta_m", "m", "towards the mill's axis", "", &Row::eta},
    {"depth_m_se", "m", "standard error of the surface there, along its normal", "",
     &Row::depth_error},
}};

}  // namespace

std::span<const CsvColumn<ProfileNodeRow>> profile_columns() { return columns; }

std::string profiles_csv(const std::vector<ProfileRow>& rows) {
  std::vector<Row> nodes;
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.nodes.size(); ++i)
      nodes.push_back({row.cycle, row.step, row.operating_hours, static_cast<int>(i),
                       row.nodes[i].x(), row.nodes[i].y(), row.depth_error[i]});
  return csv_table(profiles_format, profile_columns(), nodes);
}

std::vector<ProfileRow> read_profiles_csv(const std::filesystem::path& path) {
  std::vector<ProfileRow> rows;
  const auto nodes = read_csv_table(path, profiles_format, profile_columns());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Row& node = nodes[i];
    if (node.node == 0) rows.push_back({node.cycle, node.step, node.operating_hours, {}, {}});
    if (rows.empty() || rows.back().cycle != node.cycle || rows.back().step != node.step ||
        node.node != static_cast<int>(rows.back().nodes.size()))
      throw ResultRejected(fmt::format("{}:{}: node {} of cycle {}, step {} is out of order",
                                       path.string(), line_of_row(i), node.node, node.cycle,
                                       node.step));
    rows.back().nodes.emplace_back(node.xi, node.eta);
    rows.back().depth_error.push_back(node.depth_error);
  }
  return rows;
}

}  // namespace millwear::orchestrator
