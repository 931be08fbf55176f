#include "orchestrator/loads/cycle_load.h"

#include "orchestrator/campaign/ledger.h"
#include "orchestrator/loads/hit_power.h"
#include "orchestrator/loads/kept_file.h"
#include "orchestrator/loads/spectra.h"
#include "wear/record/load_accumulator.h"
#include "wear/record/load_read.h"
#include "wear/record/load_write.h"

namespace millwear::orchestrator {

template <>
struct Fields<wear::ArcCurve> {
  using T = wear::ArcCurve;
  static constexpr auto all = std::tuple(&T::bin_edges, &T::values);
};

template <>
struct Fields<wear::SmoothedLoss> {
  using T = wear::SmoothedLoss;
  static constexpr auto all =
      std::tuple(&T::rate, &T::moved_share, &T::strength, &T::block_modes, &T::bias_modes);
};

template <>
struct Fields<wear::PackedDataset> {
  using T = wear::PackedDataset;
  static constexpr auto all = std::tuple(&T::name, &T::unit, &T::sizes, &T::bytes);
};

template <>
struct Fields<wear::PackedLoad> {
  using T = wear::PackedLoad;
  static constexpr auto all = std::tuple(&T::cycle, &T::datasets);
};

template <>
struct Fields<LoadLine> {
  using T = LoadLine;
  static constexpr auto all =
      std::tuple(&T::raw, &T::standard_error, &T::smoothed, &T::smoothed_error);
};

template <>
struct Fields<LoadAlongProfile> {
  using T = LoadAlongProfile;
  static constexpr auto all =
      std::tuple(&T::cycle, &T::arc_length, &T::width, &T::centres, &T::contacts,
                 &T::normal_dissipation, &T::sliding_work, &T::depth_rate);
};

template <>
struct Fields<ImpactLine> {
  using T = ImpactLine;
  static constexpr auto all =
      std::tuple(&T::name, &T::normal, &T::shear, &T::events_per_second, &T::normal_power,
                 &T::shear_power, &T::unfinished_share, &T::impact_speed);
};

template <>
struct Fields<Impacts> {
  using T = Impacts;
  static constexpr auto all = std::tuple(&T::cycle, &T::liner, &T::particles);
};

template <>
struct Fields<CycleLoad> {
  using T = CycleLoad;
  static constexpr auto all =
      std::tuple(&T::smoothed, &T::by_block, &T::worn_by_load, &T::block_count, &T::path_over_slip,
                 &T::bins, &T::along, &T::impacts, &T::hit_power, &T::spectrum_lines);
};

namespace {

std::filesystem::path load_file(const Campaign& campaign, int cycle) {
  return campaign.folder.stage({cycle, StageKind::dem}) / stage_files::load;
}

CycleLoad worked_out(const Campaign& campaign, int cycle) {
  const auto& mill = campaign.mill;
  const auto record = wear::read_record(load_file(campaign, cycle));
  const auto rate = wear::rate_of_load(mill.wear, mill.charge.classes, record.load);
  const auto bins = wear::packed({cycle, wear::coarsened(record.load, wear::cells_per_bin)});
  return {.smoothed = rate.smoothed,
          .by_block = rate.by_block,
          .worn_by_load = rate.raw.dot(rate.load.bin_widths()),
          .block_count = static_cast<int>(record.load.block_count),
          .path_over_slip = path_over_slip(record.load),
          .bins = bins,
          .along = load_along_profile(mill, cycle, rate),
          .impacts = impacts_of(cycle, record, mill),
          .hit_power = hit_power(record),
          .spectrum_lines = spectrum_lines(spectrum_rows(cycle, record, class_names(mill)))};
}

}  // namespace

CycleLoad load_of_cycle(const Campaign& campaign, int cycle, const std::string& load_hash) {
  const auto file = kept_file(campaign.folder, cycle, "load");
  const std::string key = kept_key(campaign.mill, load_hash);
  if (auto kept = kept_value<CycleLoad>(file, key)) return std::move(*kept);
  CycleLoad load = worked_out(campaign, cycle);
  keep(file, key, packed_bytes(load));
  return load;
}

CycleLoad load_of_cycle(const Campaign& campaign, int cycle) {
  return load_of_cycle(campaign, cycle, hash_of_file(load_file(campaign, cycle)));
}

wear::TimedLoad timed_load(double time, const LinerProfile& dem_liner, const CycleLoad& load) {
  return {time, dem_liner, load.smoothed.rate, load.by_block};
}

}  // namespace millwear::orchestrator
