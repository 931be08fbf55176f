#include "orchestrator/results/cycle_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mill/base/constants.h"
#include "mill/case/case_units.h"
#include "mill/case/operated_mill.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/campaign/kept_cycle.h"
#include "orchestrator/dem_run/measured.h"
#include "orchestrator/dem_run/mixing.h"
#include "orchestrator/loads/kept_value.h"
#include "wear/band/campaign_band.h"
#include "wear/numerics/arc_curve.h"
#include "wear/numerics/block_means.h"
#include "wear/numerics/random_stream.h"
#include "wear/rate/smoothing_error.h"
#include "wear/surface/roughness.h"

namespace millwear {

template <class Archive>
void serialize(Archive& archive, LinerSector& value) {
  archive(value.shell_radius, value.plate_radius, value.rows);
}

template <class Archive>
void serialize(Archive& archive, LinerProfile& value) {
  archive(value.sector, value.nodes);
}

}  // namespace millwear

namespace millwear::wear {

template <class Archive>
void serialize(Archive& archive, MotionMeasures& value) {
  orchestrator::serialize_bytes(archive, value);
}

template <class Archive>
void serialize(Archive& archive, LinerReplicates& value) {
  archive(value.profile, value.deeper);
}

}  // namespace millwear::wear

namespace millwear::orchestrator {

template <class Archive>
void serialize(Archive& archive, HistoryRow& value) {
  serialize_bytes(archive, value);
}

template <class Archive>
void serialize(Archive& archive, ProfileRow& value) {
  archive(value.cycle, value.step, value.operating_hours, value.nodes, value.depth_error);
}

template <class Archive>
void serialize(Archive& archive, ReplicateRow& value) {
  archive(value.cycle, value.step, value.operating_hours, value.heights, value.plates);
}

template <class Archive>
void serialize(Archive& archive, Conservation& value) {
  archive(value.cycle, value.removed, value.accounted, value.moved_by_smoothing, value.rejected,
          value.revolutions, value.peak_error, value.path_over_slip, value.load_scatter, value.end);
}

template <class Archive>
void serialize(Archive& archive, PowerSeries& value) {
  archive(value.cycle, value.time, value.power);
}

template <class Archive>
void serialize(Archive& archive, CampaignMoment& value) {
  archive(value.time, value.hours, value.liner, value.begun_hours);
}

template <class Archive>
void serialize(Archive& archive, CycleResults& value) {
  archive(value.load_time, value.rotation, value.continues, value.history, value.profiles,
          value.replicates, value.step_durations, value.conservation, value.power, value.motion,
          value.warning, value.liners_after, value.after);
}

namespace {

constexpr Eigen::Index replicates = 200;

std::vector<double> as_vector(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

/// The feed rate at a time [kg/s], none where none is known.
std::optional<double> feed_rate_at(const Case& mill, const LinerMoment& moment) {
  return as_operated(mill, changes_begun(mill.campaign.operation, moment)).feed_rate;
}

/// The row of a geometry step. `operated` is the mill as in the cycle.
HistoryRow row_of(const Case& mill, const Case& operated, const CampaignMoment& after,
                  const Measured& measured, int cycle, int step, Rotation rotation) {
  const auto& fresh = mill.liner;
  const auto& [time, hours, liner, begun_hours] = after;
  const auto& changes = mill.campaign.operation;
  const auto feed = feed_rate_at(mill, {time, lifter_height(liner)});
  return {.cycle = cycle,
          .step = step,
          .operating_hours = hours,
          .calendar_hours = calendar_hours(changes, begun_hours, hours),
          .tonnes = tonnes_milled(mill.feed_rate, changes, begun_hours, hours),
          .lifter_height = lifter_height(liner),
          .face_angle = leading_face_angle(as_turned(liner, rotation)),
          .plate_thickness = plate_thickness(liner),
          .worn_volume = steel_area(fresh) - steel_area(liner),
          .worn_fraction = 1.0 - lifter_area(liner) / lifter_area(fresh),
          .roughness = wear::roughness(liner, 0.5 * smallest_diameter(mill.charge.classes)),
          .power = measured.power,
          .shoulder = measured.charge.shoulder,
          .toe = measured.charge.toe,
          .power_error = measured.power_error,
          .shoulder_error = measured.charge.shoulder_error,
          .toe_error = measured.charge.toe_error,
          .lifter_height_error = 0.0,
          .plate_thickness_error = 0.0,
          .worn_volume_error = 0.0,
          .airborne_share = measured.motion.airborne_share.value,
          .airborne_share_error = measured.motion.airborne_share.error,
          .bare_hit_power = measured.motion.bare_hit_power.value,
          .bare_hit_power_error = measured.motion.bare_hit_power.error,
          .dead_zone_share = measured.motion.dead_zone_share.value,
          .dead_zone_share_error = measured.motion.dead_zone_share.error,
          .between_locked_share = measured.motion.between_locked_share.value,
          .between_locked_share_error = measured.motion.between_locked_share.error,
          .speed = operated.speed / speed_from_rpm(1.0),
          .total_filling = filling_inside_plate(operated),
          .feed_rate = feed ? *feed / feed_from_t_per_h(1.0) : std::nan("")};
}

/// What to keep in mind of the charge a cycle began with, where it was mixed anew.
std::optional<std::string> mixing_warning(const Campaign& campaign, const Case& operated,
                                          const Ledger& ledger, int cycle) {
  const StageId stage{cycle, StageKind::mix};
  if (!campaign.mill.dem.mix_until_steady || ledger.find(stage) == nullptr) return std::nullopt;
  const auto record = read_mixing(operated, campaign.folder.stage(stage));
  if (mixing_state(record.plan, record.pieces) == MixingState::steady) return std::nullopt;
  return fmt::format("cycle {}: {}; raise `mix_revolutions`", cycle, spoken_mixing(record));
}

/// A value of even bins along a profile at each of its nodes.
std::vector<double> at_nodes(const LinerProfile& profile, const Eigen::VectorXd& by_bin) {
  const auto lengths = arc_lengths(profile);
  const wear::ArcCurve curve{Eigen::VectorXd::LinSpaced(by_bin.size() + 1, 0.0, lengths.back()),
                             by_bin};
  std::vector<double> values;
  for (const double arc_length : lengths) values.push_back(curve.at(arc_length));
  return values;
}

/// A cycle without its band: rows of the history with no errors, profiles with none.
CycleResults without_band(const Campaign& campaign, const Ledger& ledger, int cycle,
                          const CycleLoad& load, const CampaignMoment& before) {
  const auto& mill = campaign.mill;
  const auto& plan = mill.campaign;
  const LinerMoment first{before.time, lifter_height(before.liner)};
  const Case operated = as_operated(mill, changes_begun(plan.operation, first));
  const auto measured =
      read_measured(campaign.folder.stage({cycle, StageKind::dem}) / stage_files::measured);
  const auto kept = read_cycle(campaign.folder.stage({cycle, StageKind::wear}) / stage_files::steps,
                               mill.liner.sector);
  CycleResults results{
      .load_time = before.time,
      .rotation = rotation_at(plan, first),
      .continues = cycle > 0 && first_cycle_of_operation(campaign, cycle) < cycle,
      .history = {},
      .profiles = {},
      .replicates = {},
      .step_durations = {},
      .conservation = {cycle, 0.0, 0.0, kept.smoothing_moved_share, measured.rejected_share,
                       measured.revolutions, measured.peak_error, load.path_over_slip, 1.0,
                       std::string(name_of(end_of(measured)))},
      .power = {cycle, as_vector(wear::block_means(measured.power_times, load.block_count)),
                as_vector(wear::block_means(measured.power_series, load.block_count))},
      .motion = measured.motion,
      .warning = mixing_warning(campaign, operated, ledger, cycle),
      .liners_after = {},
      .after = before};
  auto& [time, hours, liner, begun_hours] = results.after;
  begun_hours = begun_hours_after(plan.operation, std::move(begun_hours), first, hours);
  if (cycle == 0) {
    results.history.push_back(
        row_of(mill, operated, results.after, measured, 0, 0, results.rotation));
    results.profiles.push_back(
        {0, 0, 0.0, mill.liner.nodes, std::vector<double>(mill.liner.nodes.size(), 0.0)});
    results.replicates.push_back(
        {0, 0, 0.0, Eigen::VectorXd::Constant(replicates, lifter_height(mill.liner)),
         Eigen::VectorXd::Constant(replicates, plate_thickness(mill.liner))});
  }
  for (const auto& step : kept.steps) {
    const int number = static_cast<int>(results.step_durations.size()) + 1;
    time += step.duration;
    hours += step.duration / seconds_per_hour;
    liner = step.profile;
    begun_hours = begun_hours_after(plan.operation, std::move(begun_hours),
                                    {time, lifter_height(liner)}, hours);
    results.step_durations.push_back(step.duration);
    results.history.push_back(
        row_of(mill, operated, results.after, measured, cycle, number, results.rotation));
    results.profiles.push_back({cycle, number, hours, liner.nodes, {}});
    results.conservation.removed += step.removed_area;
    results.conservation.accounted += step.accounted_area + step.fallen_area;
  }
  return results;
}

/// The liner of a cycle in the DEM's frame.
LinerProfile dem_liner(const CycleResults& cycle, const LinerProfile& liner) {
  return as_turned(liner, cycle.rotation);
}

/// The rows of a cycle's steps, without the new liner.
std::size_t first_step_row(const CycleResults& cycle) {
  return cycle.history.size() - cycle.step_durations.size();
}

/// A cycle's load with replicates of what is not known of it, and the steps that were taken on it.
wear::WornCycle worn_cycle(const Case& mill, int number, const CycleResults& cycle,
                           const LinerProfile& liner, const CycleLoad& load) {
  const auto seed = wear::random_bits(mill.dem.seed, static_cast<std::uint64_t>(number));
  wear::WornCycle worn{
      timed_load(cycle.load_time, dem_liner(cycle, liner), load),
      wear::rate_replicates(load.smoothed, replicates, seed, wear::ReplicateOf::noise),
      {},
      cycle.rotation,
      cycle.continues};
  for (std::size_t i = 0; i < cycle.step_durations.size(); ++i) {
    const LinerProfile after{mill.liner.sector, cycle.profiles[first_step_row(cycle) + i].nodes};
    worn.steps.push_back({cycle.step_durations[i], dem_liner(cycle, after)});
  }
  return worn;
}

void add_band(const wear::CycleBand& band, const wear::WornCycle& worn, CycleResults& results) {
  const std::size_t first = first_step_row(results);
  for (std::size_t step = 0; step < band.steps.size(); ++step) {
    const auto& after = band.steps[step];
    auto& history = results.history.at(first + step);
    history.lifter_height_error = after.height_error;
    history.plate_thickness_error = after.plate_error;
    history.worn_volume_error = after.section_error;
    results.replicates.push_back({history.cycle, history.step, history.operating_hours,
                                  after.replicates.heights, after.replicates.plates});
    results.profiles.at(first + step).depth_error =
        as_turned(at_nodes(worn.steps[step].profile, after.depth_error), results.rotation);
  }
  results.conservation.load_scatter = band.load_scatter;
  results.liners_after = band.after;
}

/// For every cycle the key of what all cycles up to it left.
std::vector<std::string> keys_of(const Case& mill, const Ledger& ledger, std::size_t cycles) {
  std::vector<std::string> outputs(cycles);
  for (const auto& entry : ledger.entries)
    if (static_cast<std::size_t>(entry.stage.cycle) < cycles)
      for (const auto& [name, hash] : entry.outputs)
        outputs[static_cast<std::size_t>(entry.stage.cycle)] +=
            fmt::format("{} {} {}\n", name_of(entry.stage), name, hash);
  std::vector<std::string> keys;
  std::string before = kept_key(mill, "results of cycles");
  for (const auto& of_cycle : outputs) {
    before = hash_of_text(before + of_cycle);
    keys.push_back(before);
  }
  return keys;
}

}  // namespace

std::vector<CycleLoad> loads_of_cycles(const Campaign& campaign, const Ledger& ledger) {
  std::vector<CycleLoad> loads;
  for (int cycle = 0; ledger.find({cycle, StageKind::wear}) != nullptr; ++cycle) {
    const auto* measured = ledger.find({cycle, StageKind::dem});
    loads.push_back(load_of_cycle(campaign, cycle, measured->outputs.at(stage_files::load)));
  }
  return loads;
}

std::vector<CycleResults> results_of_cycles(const Campaign& campaign, const Ledger& ledger,
                                            const std::vector<CycleLoad>& loads) {
  constexpr std::size_t ahead = wear::band_looks_aside_after;
  constexpr std::size_t behind = wear::band_looks_aside_before;
  const auto& mill = campaign.mill;
  const auto keys = keys_of(mill, ledger, loads.size());
  const auto file = [&](std::size_t cycle) {
    return kept_file(campaign.folder, static_cast<int>(cycle), "results");
  };
  std::vector<CycleResults> results;
  while (results.size() + ahead < loads.size()) {
    auto kept = kept_value<CycleResults>(file(results.size()), keys[results.size() + ahead]);
    if (!kept) break;
    results.push_back(std::move(*kept));
  }
  const std::size_t first = results.size();
  const std::size_t from = first - std::min(first, behind);
  std::vector<wear::WornCycle> worn;  // from cycle `from` on
  for (std::size_t i = from; i < loads.size(); ++i) {
    const auto before = i > 0 ? results[i - 1].after : CampaignMoment{0.0, 0.0, mill.liner, {}};
    const int number = static_cast<int>(i);
    if (i >= first) results.push_back(without_band(campaign, ledger, number, loads[i], before));
    worn.push_back(worn_cycle(mill, number, results[i], before.liner, loads[i]));
  }
  for (std::size_t i = first; i < loads.size(); ++i) {
    const auto band = wear::band_of_cycle(
        worn, i - from, i > 0 ? results[i - 1].liners_after : wear::first_replicates(worn.front()),
        mill.campaign.scheme);
    add_band(band, worn[i - from], results[i]);
    if (i + ahead < loads.size()) keep_value(file(i), keys[i + ahead], results[i]);
  }
  return results;
}

}  // namespace millwear::orchestrator
