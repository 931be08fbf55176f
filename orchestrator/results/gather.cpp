#include "orchestrator/results/gather.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>

#include "mill/base/constants.h"
#include "mill/case/operated_mill.h"
#include "mill/case/time_step.h"
#include "mill/case_file/case_warnings.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/campaign/stage_order.h"
#include "orchestrator/dem_run/progress.h"
#include "orchestrator/loads/cycle_load.h"
#include "orchestrator/results/cycle_results.h"
#include "orchestrator/results/life_error.h"
#include "orchestrator/results/load_warnings.h"
#include "wear/band/life_band.h"
#include "wear/record/impact_spectrum.h"

namespace millwear::orchestrator {
namespace {

template <class T>
void append(const std::vector<T>& items, std::vector<T>& to) {
  to.insert(to.end(), items.begin(), items.end());
}

/// Adds what a cycle that began on `liner` tells.
void add_cycle(CycleLoad load, const CycleResults& cycle, const LinerProfile& liner,
               CampaignResults& data) {
  append(cycle.history, data.history);
  append(cycle.profiles, data.profiles);
  append(cycle.replicates, data.replicates);
  data.conservation.push_back(cycle.conservation);
  data.power.push_back(cycle.power);
  data.motion.push_back({cycle.conservation.cycle, cycle.motion, std::move(load.hit_power)});
  data.impacts.push_back(std::move(load.impacts));
  if (load.polar) data.polar.push_back({cycle.conservation.cycle, std::move(*load.polar)});
  load.along.centres = bin_places(liner, cycle.rotation, load.along.arc_length);
  data.loads.push_back(std::move(load.along));
  data.bins.push_back(std::move(load.bins));
  data.spectrum_lines += load.spectrum_lines;
  if (cycle.warning) data.warnings.push_back(*cycle.warning);
}

Life life_from(const Campaign& campaign, const Ledger& ledger, const CampaignResults& data) {
  Life life{
      outcome_of(ledger) != Outcome::go_on, 0.0, std::nan(""), std::nan(""), std::nan(""), ""};
  if (!data.history.empty()) {
    life.hours = data.history.back().operating_hours;
    life.tonnes = data.history.back().tonnes;
  }
  const auto& limits = campaign.mill.campaign;
  life.limit = outcome_of(ledger) == Outcome::plate_limit
                   ? fmt::format("plate thickness {:g} mm", 1e3 * limits.plate_limit)
                   : spoken_height_limit(campaign.mill);
  return life;
}

std::string spoken_rotation(const Case& mill) {
  std::vector<std::string> hours;
  for (const double time : mill.campaign.reversal_times)
    hours.push_back(fmt::format("{:g}", time / seconds_per_hour));
  return hours.empty() ? "always the same way"
                       : fmt::format("reversed at {} operating hours", fmt::join(hours, ", "));
}

/// A line of the description, where the operation changes.
std::vector<LabelledValue> operation_of(const Case& mill) {
  if (mill.campaign.operation.empty()) return {};
  return {{"Operation", fmt::format("{}", fmt::join(spoken_operation(mill), "; "))}};
}

std::string spoken_reductions(const Case& mill) {
  std::vector<std::string> spoken;
  for (std::size_t m = 0; m < mill.materials.size(); ++m)
    spoken.push_back(fmt::format("{:g} ({})", modulus_reduction(mill, m), mill.materials[m].name));
  return fmt::format("{}", fmt::join(spoken, ", "));
}

std::vector<LabelledValue> description_of(const Case& mill) {
  const auto& sector = mill.liner.sector;
  const auto plan = plan_steps(mill);
  std::vector<LabelledValue> lines{
      {"Mill", fmt::format("{:g} m inside the shell, {} lifters, slice of {:g} m",
                           2.0 * sector.shell_radius, sector.rows, mill.slice_length)},
      {"Speed",
       fmt::format("{:.2f} rpm, {:.0f} % of critical", mill.speed * 30.0 / std::numbers::pi,
                   100.0 * critical_speed_fraction(mill))},
      {"Rotation", spoken_rotation(mill)},
      {"Charge", fmt::format("{} particles, filling {:.1f} %", totals(mill).particles,
                             100.0 * computed_filling(mill))},
      {"New lifter", fmt::format("{:.0f} mm high, leading face {:.0f}° off upright",
                                 1e3 * lifter_height(mill.liner),
                                 leading_face_angle(mill.liner) / radians_per_degree)},
      {"Wear law", spoken(mill.wear.mechanisms, mill.materials)},
      {"DEM", fmt::format("time step {:.3g} s, {} steps a revolution, moduli divided by {}",
                          plan.time_step, plan.steps_per_revolution(sector.rows),
                          spoken_reductions(mill))}};
  append(operation_of(mill), lines);
  return lines;
}

}  // namespace

CampaignResults gather(const Campaign& campaign, const Ledger& ledger) {
  const auto& mill = campaign.mill;
  CampaignResults data = results_of_case(mill);
  data.description = description_of(mill);
  data.warnings = warnings(mill);
  const Eigen::VectorXd edges = wear::energy_edges();
  data.energy_edges.assign(edges.begin(), edges.end());
  auto loads = loads_of_cycles(campaign, ledger);
  const auto cycles = results_of_cycles(campaign, ledger, loads);
  for (std::size_t i = 0; i < cycles.size(); ++i)
    add_cycle(std::move(loads[i]), cycles[i], i > 0 ? cycles[i - 1].after.liner : mill.liner, data);
  std::vector<int> numbers;
  for (const auto& cycle : cycles) numbers.push_back(cycle.conservation.cycle);
  data.charge = charge_of_cycles(campaign, numbers);
  data.life = life_from(campaign, ledger, data);
  if (data.life.reached) {
    const auto band = wear::band_of(lives_of(mill, cycles));
    data.life.hours_low = band.low;
    data.life.hours_high = band.high;
  }
  if (const auto warning = shaking_warning(data.conservation)) data.warnings.push_back(*warning);
  if (const auto warning = jumping_warning(data.conservation)) data.warnings.push_back(*warning);
  if (const auto warning = life_error_warning(mill, data.life)) data.warnings.push_back(*warning);
  double wall = 0.0;
  for (const auto& entry : ledger.entries) wall += entry.wall_seconds;
  data.provenance = {{"Program", ledger.start.program},
                     {"Case", ledger.start.case_hash},
                     {"Ranks", std::to_string(ledger.start.ranks)},
                     {"Host", ledger.start.host},
                     {"Seed of the packing", std::to_string(mill.dem.seed)},
                     {"Wall time", spoken_time(wall)}};
  return data;
}

}  // namespace millwear::orchestrator
