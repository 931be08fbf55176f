#include "orchestrator/results/replicates.h"

#include <fmt/format.h>

#include <charconv>
#include <iterator>

#include "mill/base/csv.h"
#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

constexpr CsvFormat format{"millwear replicates 1",
                           "cycle,step,operating_hours,lifter_height_m,plate_thickness_m"};

std::string list_of(const Eigen::VectorXd& lengths) {
  std::string text;
  for (const double length : lengths)
    fmt::format_to(std::back_inserter(text), "{}{:.6f}", text.empty() ? "" : " ", length);
  return text;
}

/// The numbers of a list; empty where one of them is none.
Eigen::VectorXd numbers_in(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  while (at < end) {
    const auto [after, error] = std::from_chars(at, end, numbers.emplace_back());
    if (error != std::errc() || (after < end && *after != ' ')) return {};
    at = after < end ? after + 1 : end;
  }
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

}  // namespace

std::string replicates_csv(const std::vector<ReplicateRow>& rows) {
  std::string text = csv_head(format);
  for (const auto& row : rows)
    text += fmt::format("{},{},{},{},{}\n", row.cycle, row.step, csv_number(row.operating_hours),
                        list_of(row.heights), list_of(row.plates));
  return text;
}

std::vector<ReplicateRow> read_replicates_csv(const std::filesystem::path& path) {
  std::vector<ReplicateRow> rows;
  for (const auto& line : read_csv(path, format)) {
    CsvFields fields(path, line);
    const int cycle = fields.integer();
    const int step = fields.integer();
    const double hours = fields.number();
    const Eigen::VectorXd heights = numbers_in(fields.text());
    const Eigen::VectorXd plates = numbers_in(fields.text());
    const Eigen::Index count = rows.empty() ? heights.size() : rows.front().heights.size();
    if (heights.size() == 0 || heights.size() != count || plates.size() != count)
      throw ResultRejected(fmt::format(
          "{}:{}: {} lifter heights and {} plate thicknesses that are numbers, where {} of each "
          "should be; write it anew with `millwear report`",
          path.string(), line.number, heights.size(), plates.size(), count));
    rows.push_back({cycle, step, hours, heights, plates});
  }
  return rows;
}

}  // namespace millwear::orchestrator
