#include "orchestrator/loads/cycle_load.h"

#include "orchestrator/campaign/ledger.h"
#include "orchestrator/loads/hit_power.h"
#include "orchestrator/loads/kept_value.h"
#include "orchestrator/loads/spectra.h"
#include "wear/record/load_accumulator.h"
#include "wear/record/load_read.h"
#include "wear/record/load_write.h"

namespace millwear::wear {

template <class Archive>
void serialize(Archive& archive, ArcCurve& value) {
  archive(value.bin_edges, value.values);
}

template <class Archive>
void serialize(Archive& archive, SmoothedLoss& value) {
  archive(value.rate, value.path, value.per_path, value.moved_share, value.strength,
          value.block_modes, value.bias_modes);
}

template <class Archive>
void serialize(Archive& archive, RollingBalls& value) {
  archive(value.smallest, value.mean);
}

template <class Archive>
void serialize(Archive& archive, Rolling& value) {
  archive(value.path, value.per_path, value.balls, value.corrosion);
}

template <class Archive>
void serialize(Archive& archive, PolarLoad& value) {
  archive(value.values);
}

template <class Archive>
void serialize(Archive& archive, PackedDataset& value) {
  archive(value.name, value.unit, value.sizes, value.bytes);
}

template <class Archive>
void serialize(Archive& archive, PackedLoad& value) {
  archive(value.cycle, value.datasets);
}

}  // namespace millwear::wear

namespace millwear::orchestrator {

template <class Archive>
void serialize(Archive& archive, LoadLine& value) {
  archive(value.raw, value.standard_error, value.smoothed, value.smoothed_error);
}

template <class Archive>
void serialize(Archive& archive, LoadAlongProfile& value) {
  archive(value.cycle, value.arc_length, value.width, value.centres, value.contacts,
          value.normal_dissipation, value.sliding_work, value.depth_rate);
}

template <class Archive>
void serialize(Archive& archive, ImpactLine& value) {
  archive(value.name, value.normal, value.shear, value.events_per_second, value.normal_power,
          value.shear_power, value.unfinished_share, value.impact_speed);
}

template <class Archive>
void serialize(Archive& archive, Impacts& value) {
  archive(value.cycle, value.liner, value.particles);
}

template <class Archive>
void serialize(Archive& archive, CycleLoad& value) {
  archive(value.smoothed, value.by_block, value.rolling, value.worn_by_load, value.block_count,
          value.path_over_slip, value.bins, value.along, value.impacts, value.hit_power,
          value.polar, value.spectrum_lines);
}

namespace {

std::filesystem::path load_file(const Campaign& campaign, int cycle) {
  return campaign.folder.stage({cycle, StageKind::dem}) / stage_files::load;
}

CycleLoad worked_out(const Campaign& campaign, int cycle) {
  const Case mill = as_operated(campaign, cycle).mill;
  const LinerProfile liner = dem_liner_of_cycle(campaign, cycle);
  const auto record = wear::read_record(load_file(campaign, cycle));
  const auto rate = wear::rate_of_load(mill.wear, mill.charge.classes, liner, record.load);
  const auto bins = wear::packed({cycle, wear::coarsened(record.load, wear::cells_per_bin)});
  return {.smoothed = rate.smoothed,
          .by_block = rate.by_block,
          .rolling = wear::rolling_of(rate),
          .worn_by_load = rate.raw.dot(rate.load.bin_widths()),
          .block_count = static_cast<int>(record.load.block_count),
          .path_over_slip = path_over_slip(record.load),
          .bins = bins,
          .along = load_along_profile(cycle, rate),
          .impacts = impacts_of(cycle, record, mill),
          .hit_power = hit_power(record),
          .polar = record.polar,
          .spectrum_lines = spectrum_lines(spectrum_rows(cycle, record, class_names(mill)))};
}

}  // namespace

CycleLoad load_of_cycle(const Campaign& campaign, int cycle, const std::string& load_hash) {
  const auto file = kept_file(campaign.folder, cycle, "load");
  const std::string key = kept_key(campaign.mill, load_hash);
  if (auto kept = kept_value<CycleLoad>(file, key)) return std::move(*kept);
  CycleLoad load = worked_out(campaign, cycle);
  keep_value(file, key, load);
  return load;
}

CycleLoad look_at_load_of_cycle(const Campaign& campaign, int cycle, const std::string& load_hash) {
  auto kept = kept_value<CycleLoad>(kept_file(campaign.folder, cycle, "load"),
                                    kept_key(campaign.mill, load_hash));
  return kept ? std::move(*kept) : worked_out(campaign, cycle);
}

CycleLoad load_of_cycle(const Campaign& campaign, int cycle) {
  return load_of_cycle(campaign, cycle, hash_of_file(load_file(campaign, cycle)));
}

wear::TimedLoad timed_load(double time, const LinerProfile& dem_liner, const CycleLoad& load) {
  return {time, dem_liner, load.smoothed.rate, load.by_block, load.rolling};
}

}  // namespace millwear::orchestrator
