#include "orchestrator/study/campaign_figures.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "liggghts_inputs/decks/stretch.h"
#include "mill/base/constants.h"
#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/campaign/run_folder.h"
#include "orchestrator/dem_run/measured.h"
#include "orchestrator/results/history.h"
#include "orchestrator/study/derived_axes.h"
#include "orchestrator/study/liner_impacts.h"
#include "wear/band/life_band.h"

namespace millwear::orchestrator {
namespace {

using Figures = CampaignFigures;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double watts_per_kilowatt = 1e3;

constexpr std::array columns{
    FigureColumn{"life_hours", "h", "operating hours until a limit is reached",
                 &Figures::life_hours, &Figures::life_hours_error},
    FigureColumn{"life_tonnes", "t", "milled by then; empty without a feed rate",
                 &Figures::life_tonnes, nullptr},
    FigureColumn{"steel_kg_per_t_m", "kg/(t m)",
                 "steel lost per tonne milled and metre of mill; empty without a feed rate",
                 &Figures::steel_per_tonne, &Figures::steel_per_tonne_error},
    FigureColumn{"lifter_height_m", "m", "at the end", &Figures::height, &Figures::height_error},
    FigureColumn{"plate_thickness_m", "m", "least, at the end", &Figures::plate,
                 &Figures::plate_error},
    FigureColumn{"worn_volume_m3_per_m", "m3/m", "per lifter and metre of mill, at the end",
                 &Figures::worn_volume, &Figures::worn_volume_error},
    FigureColumn{"power_w", "W", "drawn by the slice, mean over the life", &Figures::power,
                 &Figures::power_error},
    FigureColumn{"power_new_w", "W", "the same with the new liner", &Figures::power_new,
                 &Figures::power_new_error},
    FigureColumn{"energy_kwh_per_t_m", "kWh/(t m)",
                 "power per metre of mill over the feed; empty without a feed rate",
                 &Figures::energy_per_tonne, &Figures::energy_per_tonne_error},
    FigureColumn{"shoulder_deg", "degree", "with the new liner, as in `history.csv`",
                 &Figures::shoulder, &Figures::shoulder_error},
    FigureColumn{"toe_deg", "degree", "likewise", &Figures::toe, &Figures::toe_error},
    FigureColumn{"dead_zone_share", "1", "with the new liner, as in `history.csv`",
                 &Figures::dead_zone_share, &Figures::dead_zone_share_error},
    FigureColumn{"bare_hit_power_w", "W", "likewise", &Figures::bare_hit_power,
                 &Figures::bare_hit_power_error},
    FigureColumn{"impact_power_w", "W",
                 "dissipated in hits on the new liner, normal to it (`spectra.csv`)",
                 &Figures::impact_power, nullptr},
    FigureColumn{"impact_half_energy_j", "J",
                 "hits on the new liner that dissipate more than this make half of that power",
                 &Figures::impact_half_energy, nullptr},
    FigureColumn{"wear_rate_new_m3_per_m_h", "m3/(m h)",
                 "per lifter and metre of mill, over the steps on the first load",
                 &Figures::wear_rate_new, &Figures::wear_rate_new_error},
    FigureColumn{"rows", "1", "lifters around the mill", &Figures::rows, nullptr},
    FigureColumn{"spacing_m", "m", "from lifter to lifter along the new plate", &Figures::spacing,
                 nullptr},
    FigureColumn{"spacing_to_height", "1", "of the new lifters", &Figures::spacing_to_height,
                 nullptr},
    FigureColumn{"cycles", "1", "DEM loads of the life", &Figures::cycles, nullptr},
    FigureColumn{"dem_particle_steps", "1",
                 "cost of the DEM: particles times time steps, mixing as planned",
                 &Figures::particle_steps, nullptr},
};

/// A number of the summary; NaN for null.
double number_in(const nlohmann::json& summary, const char* key) {
  const auto& value = summary.at(key);
  return value.is_number() ? value.get<double>() : nan;
}

/// The mean of a load's value over the life, each load for the hours of its cycle, with its error.
std::pair<double, double> mean_over_life(const std::vector<HistoryRow>& history,
                                         double HistoryRow::*value, double HistoryRow::*error) {
  double sum = 0.0;
  double hours = 0.0;
  double variance = 0.0;
  double of_cycle = 0.0;
  for (std::size_t i = 1; i < history.size(); ++i) {
    const double duration = history[i].operating_hours - history[i - 1].operating_hours;
    sum += duration * history[i].*value;
    hours += duration;
    of_cycle += duration;
    const bool is_last = i + 1 == history.size() || history[i + 1].cycle != history[i].cycle;
    if (!is_last) continue;
    variance += std::pow(of_cycle * history[i].*error, 2);
    of_cycle = 0.0;
  }
  return {sum / hours, std::sqrt(variance) / hours};
}

/// The last state that the first load has led to.
const HistoryRow& after_first_load(const std::vector<HistoryRow>& history) {
  std::size_t last = 1;
  while (last + 1 < history.size() && history[last + 1].cycle == history[1].cycle) ++last;
  return history[last];
}

/// NaN where no collision was recorded.
LinerImpacts impacts_in(const std::filesystem::path& results) {
  const auto file = results / "spectra.csv";
  return liner_impacts(std::filesystem::exists(file) ? read_spectra_csv(file)
                                                     : std::vector<SpectrumRow>{});
}

/// Of the mixing as planned, and of every load as it was measured.
double particle_steps_of(const std::filesystem::path& campaign, const Case& mill, int cycles) {
  const auto plan = plan_steps(mill);
  const auto per_revolution =
      static_cast<double>(plan.steps_per_revolution(mill.liner.sector.rows));
  auto steps = static_cast<double>(liggghts::mixing_steps(mill, plan).total());
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const auto file = RunFolder{campaign}.stage({cycle, StageKind::dem}) / stage_files::measured;
    steps += static_cast<double>(mill.dem.settle_pitches * plan.steps_per_pitch) +
             per_revolution * read_measured(file).revolutions;
  }
  return steps * static_cast<double>(totals(mill).particles);
}

}  // namespace

std::span<const FigureColumn> figure_columns() { return columns; }

double wall_hours(const std::filesystem::path& campaign) {
  const auto ledger = read_ledger(RunFolder{campaign}.ledger());
  double seconds = 0.0;
  if (ledger)
    for (const auto& entry : ledger->entries) seconds += entry.wall_seconds;
  return seconds / seconds_per_hour;
}

Figures figures_of(const std::filesystem::path& campaign, const Case& mill) {
  const auto results = RunFolder{campaign}.results();
  const auto history = read_history_csv(results / "history.csv");
  const auto file = results / "summary.json";
  const auto summary = nlohmann::json::parse(read_file(file), nullptr, false);
  if (summary.is_discarded() || history.size() < 2)
    throw ResultRejected(
        fmt::format("{}: no results of a finished campaign; `millwear report {}` "
                    "writes them anew",
                    file.string(), (campaign / "case.toml").string()));
  const HistoryRow& fresh = history.front();
  const HistoryRow& last = history.back();
  const HistoryRow& first_worn = after_first_load(history);
  const LinerImpacts impacts = impacts_in(results);
  const auto [power, power_error] =
      mean_over_life(history, &HistoryRow::power, &HistoryRow::power_error);
  const double density = mill.materials.at(mill.liner_material).density;
  const double steel = density * mill.liner.sector.rows / last.tonnes;
  const double per_tonne = mill.feed_rate
                               ? 1.0 / (mill.slice_length * watts_per_kilowatt * *mill.feed_rate *
                                        seconds_per_hour / kilograms_per_tonne)
                               : nan;
  const bool is_worn_out = summary.at("life_reached").get<bool>();
  return {.life_hours = is_worn_out ? number_in(summary, "life_hours") : nan,
          .life_hours_error = wear::standard_error_of(
              {number_in(summary, "life_hours_low"), number_in(summary, "life_hours_high")}),
          .life_tonnes = is_worn_out ? number_in(summary, "life_tonnes") : nan,
          .steel_per_tonne = steel * last.worn_volume,
          .steel_per_tonne_error = steel * last.worn_volume_error,
          .height = last.lifter_height,
          .height_error = last.lifter_height_error,
          .plate = last.plate_thickness,
          .plate_error = last.plate_thickness_error,
          .worn_volume = last.worn_volume,
          .worn_volume_error = last.worn_volume_error,
          .power = power,
          .power_error = power_error,
          .power_new = fresh.power,
          .power_new_error = fresh.power_error,
          .energy_per_tonne = per_tonne * power,
          .energy_per_tonne_error = per_tonne * power_error,
          .shoulder = fresh.shoulder * degrees_per_radian,
          .shoulder_error = fresh.shoulder_error * degrees_per_radian,
          .toe = fresh.toe * degrees_per_radian,
          .toe_error = fresh.toe_error * degrees_per_radian,
          .dead_zone_share = fresh.dead_zone_share,
          .dead_zone_share_error = fresh.dead_zone_share_error,
          .bare_hit_power = fresh.bare_hit_power,
          .bare_hit_power_error = fresh.bare_hit_power_error,
          .impact_power = impacts.power,
          .impact_half_energy = impacts.half_energy,
          .wear_rate_new = first_worn.worn_volume / first_worn.operating_hours,
          .wear_rate_new_error = first_worn.worn_volume_error / first_worn.operating_hours,
          .rows = static_cast<double>(mill.liner.sector.rows),
          .spacing = lifter_spacing(mill),
          .spacing_to_height = lifter_spacing(mill) / lifter_height(mill.liner),
          .cycles = number_in(summary, "cycles"),
          .particle_steps = particle_steps_of(campaign, mill, summary.at("cycles").get<int>())};
}

}  // namespace millwear::orchestrator
