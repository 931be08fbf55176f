#include "orchestrator/validation/simulated_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "mill/base/csv_columns.h"
#include "mill/base/failure.h"
#include "orchestrator/dem_run/measured.h"
#include "orchestrator/results/history.h"

namespace millwear::orchestrator {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

struct Row {
  std::string quantity;
  double value;
  double error;
};

constexpr std::string_view format = "millwear simulated figures 1";
constexpr std::array<CsvColumn<Row>, 3> columns{{
    {"quantity", "", "as in `published.csv`", "", &Row::quantity},
    {"value", "", "of the first measurement, or of the worn liner", "", &Row::value},
    {"error", "", "its standard error; empty where it is not known", "", &Row::error},
}};

[[noreturn]] void refuse_short(const Campaign& campaign, std::string_view what) {
  throw Failure(ExitCode::usage, fmt::format("{}: {}; let `millwear run` go on",
                                             campaign.folder.root.string(), what));
}

Figure face_angle_at(double lifter_height, const Campaign& campaign) {
  const auto history = read_history_csv(campaign.folder.root / "results" / "history.csv");
  const auto after = std::ranges::find_if(
      history, [&](const HistoryRow& row) { return row.lifter_height <= lifter_height; });
  if (after == history.begin() || after == history.end())
    refuse_short(campaign,
                 fmt::format("the lifter has not worn to {:.0f} mm", 1e3 * lifter_height));
  const HistoryRow& before = *std::prev(after);
  const double share =
      (before.lifter_height - lifter_height) / (before.lifter_height - after->lifter_height);
  return {degrees * std::lerp(before.face_angle, after->face_angle, share)};
}

Measured first_measurement(const Campaign& campaign) {
  const auto file = campaign.folder.stage({0, StageKind::dem}) / stage_files::measured;
  if (!std::filesystem::exists(file)) refuse_short(campaign, "nothing is measured here yet");
  return read_measured(file);
}

Figure figure_of(const PublishedFigure& published, const Campaign& campaign,
                 const Measured& measured) {
  const auto& charge = measured.charge;
  switch (published.quantity) {
    case Quantity::power: {
      const double slices = *published.mill_length / campaign.mill.slice_length;
      return {slices * measured.power, slices * measured.power_error};
    }
    case Quantity::shoulder:
      return {degrees * charge.shoulder, degrees * charge.shoulder_error};
    case Quantity::toe:
      return {degrees * charge.toe, degrees * charge.toe_error};
    case Quantity::face_angle:
      return face_angle_at(*published.lifter_height, campaign);
  }
  throw std::logic_error("a quantity of no kind");
}

}  // namespace

SimulatedFigures simulated_figures(const Campaign& campaign,
                                   const std::vector<PublishedFigure>& published) {
  const Measured measured = first_measurement(campaign);
  SimulatedFigures figures;
  for (const PublishedFigure& one : published)
    figures[one.quantity] = figure_of(one, campaign, measured);
  return figures;
}

std::string simulated_csv(const SimulatedFigures& figures) {
  std::vector<Row> rows;
  for (const auto& [quantity, figure] : figures)
    rows.push_back({std::string(name_of(quantity).key), figure.value, figure.error});
  return csv_table<Row>(format, columns, rows);
}

SimulatedFigures read_simulated_csv(const std::filesystem::path& file) {
  SimulatedFigures figures;
  for (const Row& row : read_csv_table<Row>(file, format, columns)) {
    const auto found = std::ranges::find(quantity_names(), row.quantity, &QuantityName::key);
    if (found == quantity_names().end())
      throw ResultRejected(
          fmt::format("{}: no quantity is called `{}`", file.string(), row.quantity));
    figures[found->quantity] = {row.value, row.error};
  }
  return figures;
}

}  // namespace millwear::orchestrator
