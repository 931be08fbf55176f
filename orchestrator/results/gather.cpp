#include "orchestrator/results/gather.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>

#include "mill/case/time_step.h"
#include "mill/case_file/case_warnings.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/campaign/kept_cycle.h"
#include "orchestrator/campaign/stage_order.h"
#include "orchestrator/dem_run/mixing.h"
#include "orchestrator/results/impacts.h"
#include "orchestrator/results/motion_of_cycle.h"
#include "orchestrator/results/shaking_warning.h"
#include "orchestrator/results/uncertainty.h"
#include "wear/evolve/load_carrier.h"
#include "wear/numerics/block_means.h"
#include "wear/numerics/block_persistence.h"
#include "wear/rate/load_rate.h"
#include "wear/rate/smoothing_error.h"
#include "wear/record/load_read.h"

namespace millwear::orchestrator {
namespace {

constexpr double seconds_per_hour = 3600.0;
constexpr double kilograms_per_tonne = 1000.0;

std::vector<double> as_vector(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

/// Places in the steel's frame, by their arc lengths on the DEM's liner of a cycle.
std::vector<Eigen::Vector2d> places_on(const Campaign& campaign, int cycle,
                                       const Eigen::VectorXd& at) {
  const LinerProfile profile = dem_liner_of_cycle(campaign, cycle);
  const auto arc = arc_lengths(profile);
  std::vector<Eigen::Vector2d> places;
  const Rotation rotation = rotation_of_cycle(campaign, cycle);
  for (const double s : at) places.push_back(as_turned(wear::place_at(profile, arc, s), rotation));
  return places;
}

/// One measure of the load per surface of one lifter and per second, smoothed like the loss.
LoadLine rate_line(const WallLoad& load, Measure measure, const Eigen::ArrayXd& divisor,
                   const wear::Smoothing& how) {
  const Eigen::MatrixXd by_block = load.by_block(measure);
  const Eigen::VectorXd raw = load.total(measure).array() / divisor;
  const Eigen::MatrixXd block_rates = wear::as_independent(
      (by_block.array().colwise() / divisor).matrix() * static_cast<double>(load.block_count));
  const Eigen::VectorXd positive = raw.cwiseMax(0.0);
  LoadLine line{
      as_vector(raw), as_vector(wear::error_of_mean(block_rates)), as_vector(positive), {}};
  if (!(positive.sum() > 0.0)) return line;
  const auto smooth = wear::smoothed(load.bin_edges, positive, block_rates, how);
  line.smoothed = as_vector(smooth.rate.values);
  line.smoothed_error = as_vector(wear::standard_error(smooth));
  return line;
}

LoadAlongProfile load_of_cycle(const Campaign& campaign, int cycle, const wear::LoadRate& rate) {
  const auto& load = rate.load;
  const Eigen::VectorXd widths = load.bin_widths();
  const Eigen::VectorXd centres = load.bin_edges.head(load.bins()) + 0.5 * widths;
  const auto how = wear::smoothing_of(campaign.mill.wear, campaign.mill.charge.classes);
  const Eigen::ArrayXd surface_time =
      load.bin_area().array() * static_cast<double>(load.rows) * load.duration;
  return {cycle,
          as_vector(centres),
          as_vector(widths),
          places_on(campaign, cycle, centres),
          rate_line(load, Measure::samples, widths.array(), how),
          rate_line(load, Measure::normal_dissipation, surface_time, how),
          rate_line(load, Measure::sliding_work, surface_time, how),
          {as_vector(rate.raw),
           {},
           as_vector(rate.smoothed.rate.values),
           as_vector(wear::standard_error(rate.smoothed))}};
}

HistoryRow row_of(const Campaign& campaign, const LinerProfile& liner, const Measured& measured,
                  const StageId& stage, int step, double hours, Rotation rotation) {
  const auto& fresh = campaign.mill.liner;
  const auto feed = campaign.mill.feed_rate;
  return {stage.cycle,
          step,
          hours,
          feed ? *feed * hours * seconds_per_hour / kilograms_per_tonne : std::nan(""),
          lifter_height(liner),
          leading_face_angle(as_turned(liner, rotation)),
          plate_thickness(liner),
          steel_area(fresh) - steel_area(liner),
          1.0 - lifter_area(liner) / lifter_area(fresh),
          measured.power,
          measured.charge.shoulder,
          measured.charge.toe,
          measured.power_error,
          measured.charge.shoulder_error,
          measured.charge.toe_error,
          0.0,
          0.0,
          0.0,
          measured.motion.airborne_share.value,
          measured.motion.airborne_share.error,
          measured.motion.bare_hit_power.value,
          measured.motion.bare_hit_power.error,
          measured.motion.dead_zone_share.value,
          measured.motion.dead_zone_share.error,
          measured.motion.between_locked_share.value,
          measured.motion.between_locked_share.error};
}

/// The power of a cycle by blocks of its measurement.
PowerSeries power_of_cycle(int cycle, const Measured& measured, int blocks) {
  return {cycle, as_vector(wear::block_means(measured.power_times, blocks)),
          as_vector(wear::block_means(measured.power_series, blocks))};
}

/// Adds what a cycle left to the report, but for what is not known of it: that is returned.
wear::WornCycle add_cycle(const Campaign& campaign, int cycle, double time, CampaignResults& data) {
  const auto& mill = campaign.mill;
  const StageId wear_id{cycle, StageKind::wear};
  const auto measured =
      read_measured(campaign.folder.stage({cycle, StageKind::dem}) / stage_files::measured);
  const auto kept =
      read_cycle(campaign.folder.stage(wear_id) / stage_files::steps, mill.liner.sector);
  const auto recorded =
      wear::read_record(campaign.folder.stage({cycle, StageKind::dem}) / stage_files::load);
  if (cycle == 0) {
    data.history.push_back(
        row_of(campaign, mill.liner, measured, wear_id, 0, 0.0, Rotation::as_new));
    data.profiles.push_back(
        {0, 0, 0.0, mill.liner.nodes, std::vector<double>(mill.liner.nodes.size(), 0.0)});
  }
  Conservation balance{cycle,
                       0.0,
                       0.0,
                       kept.smoothing_moved_share,
                       measured.rejected_share,
                       measured.revolutions,
                       measured.peak_error,
                       path_over_slip(recorded.load),
                       std::string(name_of(end_of(measured)))};
  const Rotation rotation = rotation_of_cycle(campaign, cycle);
  double hours = data.history.back().operating_hours;
  for (std::size_t i = 0; i < kept.steps.size(); ++i) {
    const auto& step = kept.steps[i];
    const int number = static_cast<int>(i) + 1;
    hours += step.duration / seconds_per_hour;
    data.history.push_back(
        row_of(campaign, step.profile, measured, wear_id, number, hours, rotation));
    data.profiles.push_back({cycle, number, hours, step.profile.nodes, {}});
    balance.removed += step.removed_area;
    balance.accounted += step.accounted_area + step.fallen_area;
  }
  data.conservation.push_back(balance);
  data.power.push_back(
      power_of_cycle(cycle, measured, static_cast<int>(recorded.load.block_count)));
  const auto rate = wear::rate_of_load(mill.wear, mill.charge.classes, recorded.load);
  data.loads.push_back(load_of_cycle(campaign, cycle, rate));
  data.impacts.push_back(impacts_of(cycle, recorded, mill));
  data.motion.push_back(motion_of_cycle(cycle, measured, recorded));
  return worn_cycle(campaign, cycle, time, rate, kept);
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
                   : fmt::format("lifter height {:g} mm", 1e3 * limits.height_limit);
  return life;
}

std::string spoken_rotation(const Case& mill) {
  std::vector<std::string> hours;
  for (const double time : mill.campaign.reversal_times)
    hours.push_back(fmt::format("{:g}", time / seconds_per_hour));
  return hours.empty() ? "always the same way"
                       : fmt::format("reversed at {} operating hours", fmt::join(hours, ", "));
}

std::string spoken_reductions(const Case& mill) {
  std::vector<std::string> spoken;
  for (std::size_t m = 0; m < mill.materials.size(); ++m)
    spoken.push_back(fmt::format("{:g} ({})", modulus_reduction(mill, m), mill.materials[m].name));
  return fmt::format("{}", fmt::join(spoken, ", "));
}

std::vector<LabelledValue> description_of(const Case& mill) {
  const auto& sector = mill.liner.sector;
  const double degree = std::numbers::pi / 180.0;
  const auto plan = plan_steps(mill);
  return {{"Mill", fmt::format("{:g} m inside the shell, {} lifters, slice of {:g} m",
                               2.0 * sector.shell_radius, sector.rows, mill.slice_length)},
          {"Speed",
           fmt::format("{:.2f} rpm, {:.0f} % of critical", mill.speed * 30.0 / std::numbers::pi,
                       100.0 * critical_speed_fraction(mill))},
          {"Rotation", spoken_rotation(mill)},
          {"Charge", fmt::format("{} particles, filling {:.1f} %", totals(mill).particles,
                                 100.0 * computed_filling(mill))},
          {"New lifter",
           fmt::format("{:.0f} mm high, leading face {:.0f}° off upright",
                       1e3 * lifter_height(mill.liner), leading_face_angle(mill.liner) / degree)},
          {"Wear law", spoken(mill.wear.mechanisms, mill.materials)},
          {"DEM", fmt::format("time step {:.3g} s, {} steps a revolution, moduli divided by {}",
                              plan.time_step, plan.steps_per_revolution(sector.rows),
                              spoken_reductions(mill))}};
}

/// What to keep in mind of the charge a cycle began with, where it was mixed anew.
void add_mixing_warning(const Campaign& campaign, const Ledger& ledger, int cycle,
                        CampaignResults& data) {
  const StageId stage{cycle, StageKind::mix};
  if (!campaign.mill.dem.mix_until_steady || ledger.find(stage) == nullptr) return;
  const auto record = read_mixing(campaign.mill, campaign.folder.stage(stage));
  if (mixing_state(record.plan, record.pieces) != MixingState::steady)
    data.warnings.push_back(
        fmt::format("cycle {}: {}; raise `mix_revolutions`", cycle, spoken_mixing(record)));
}

}  // namespace

CampaignResults gather(const Campaign& campaign, const Ledger& ledger) {
  const auto& mill = campaign.mill;
  CampaignResults data{};
  data.case_name = mill.name;
  data.description = description_of(mill);
  data.sector = mill.liner.sector;
  data.height_limit = mill.campaign.height_limit;
  data.plate_limit = mill.campaign.plate_limit;
  data.warnings = warnings(mill);
  data.energy_edges = as_vector(wear::energy_edges());
  std::vector<wear::WornCycle> cycles;
  double time = 0.0;
  for (int cycle = 0; ledger.find({cycle, StageKind::wear}) != nullptr; ++cycle) {
    cycles.push_back(add_cycle(campaign, cycle, time, data));
    add_mixing_warning(campaign, ledger, cycle, data);
    for (const auto& step : cycles.back().steps) time += step.duration;
  }
  data.life = life_from(campaign, ledger, data);
  add_uncertainty(mill, cycles, data);
  if (const auto warning = shaking_warning(data.conservation)) data.warnings.push_back(*warning);
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
