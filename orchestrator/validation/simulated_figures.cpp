#include "orchestrator/validation/simulated_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>

#include "mill/base/csv_columns.h"
#include "mill/base/failure.h"
#include "orchestrator/charge/charge_of_cycle.h"
#include "orchestrator/dem_run/measured.h"
#include "wear/charge/bed_profile.h"
#include "wear/charge/charge_record.h"

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
    {"value", "", "of the first measurement", "", &Row::value},
    {"error", "", "its standard error; empty where it is not known", "", &Row::error},
}};

/// How the bed lay and flowed in the first measurement.
wear::BedProfile bed_of(const Campaign& campaign) {
  const auto record = wear::read_charge(
      campaign.folder.stage({0, StageKind::dem}) / stage_files::charge, wear::ChargeParts::fields);
  const auto& landmarks = charge_of_cycles(campaign, {0}).cycles.at(0).landmarks;
  return wear::bed_profile_of(record.fields, landmarks.shoulder, landmarks.bulk_toe,
                              campaign.mill.liner.sector.plate_radius);
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
    case Quantity::surface_angle:
      return {degrees * bed_of(campaign).surface_angle};
    case Quantity::surface_speed:
      return {bed_of(campaign).surface_speed};
    case Quantity::turning_depth:
      return {bed_of(campaign).turning_depth};
  }
  throw std::logic_error("a quantity of no kind");
}

}  // namespace

SimulatedFigures simulated_figures(const Campaign& campaign,
                                   const std::vector<PublishedFigure>& published) {
  const auto file = campaign.folder.stage({0, StageKind::dem}) / stage_files::measured;
  if (!std::filesystem::exists(file))
    throw Failure(ExitCode::usage,
                  fmt::format("{}: nothing is measured here yet; let `millwear run` go on",
                              campaign.folder.root.string()));
  const Measured measured = read_measured(file);
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
