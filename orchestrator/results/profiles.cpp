#include "orchestrator/results/profiles.h"

#include <fmt/format.h>

#include "mill/base/csv.h"
#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

constexpr CsvFormat format{"millwear profiles 2",
                           "cycle,step,operating_hours,node,xi_m,eta_m,depth_m_se"};

}  // namespace

std::string profiles_csv(const std::vector<ProfileRow>& rows) {
  std::string text = csv_head(format);
  for (const auto& row : rows)
    for (std::size_t node = 0; node < row.nodes.size(); ++node)
      text += fmt::format("{},{},{},{},{},{},{}\n", row.cycle, row.step,
                          csv_number(row.operating_hours), node, csv_number(row.nodes[node].x()),
                          csv_number(row.nodes[node].y()), csv_number(row.depth_error[node]));
  return text;
}

std::vector<ProfileRow> read_profiles_csv(const std::filesystem::path& path) {
  std::vector<ProfileRow> rows;
  for (const auto& line : read_csv(path, format)) {
    CsvFields fields(path, line);
    const int cycle = fields.integer();
    const int step = fields.integer();
    const double hours = fields.number();
    const int node = fields.integer();
    if (node == 0) rows.push_back({cycle, step, hours, {}, {}});
    if (rows.empty() || rows.back().cycle != cycle || rows.back().step != step ||
        node != static_cast<int>(rows.back().nodes.size()))
      throw ResultRejected(fmt::format("{}:{}: node {} of cycle {}, step {} is out of order",
                                       path.string(), line.number, node, cycle, step));
    const double xi = fields.number();
    const double eta = fields.number();
    rows.back().nodes.emplace_back(xi, eta);
    rows.back().depth_error.push_back(fields.number());
  }
  return rows;
}

}  // namespace millwear::orchestrator
