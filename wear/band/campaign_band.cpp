#include "wear/band/campaign_band.h"

#include <algorithm>
#include <cmath>

#include "mill/liner/profile_measures.h"

namespace millwear::wear {
namespace {

/// Of the mean that the replicates scatter about being the prediction: zero displacement.
double root_mean_square(const Eigen::VectorXd& deviations) {
  return deviations.norm() / std::sqrt(static_cast<double>(deviations.size()));
}

LinerBand band_after(const LinerReplicates& liners, double time) {
  LinerBand band{{time, lifter_heights(liners), plate_thicknesses(liners)}, 0, 0, 0, {}};
  band.height_error =
      root_mean_square(band.replicates.heights.array() - lifter_height(liners.profile));
  band.plate_error =
      root_mean_square(band.replicates.plates.array() - plate_thickness(liners.profile));
  band.section_error = root_mean_square(sections_ahead(liners));
  const Eigen::Index bins = liners.deeper.rows();
  band.depth_error = Eigen::VectorXd(bins);
  for (Eigen::Index bin = 0; bin < bins; ++bin)
    band.depth_error[bin] = root_mean_square(liners.deeper.row(bin));
  return band;
}

/// Between a load before the cycle's own and one after it: from one to the next, noise would hide
/// the change.
double growth_in(std::span<const WornCycle> cycles, std::size_t cycle) {
  constexpr std::size_t loads_aside = 2;
  const std::size_t first = cycle - std::min(cycle, loads_aside);
  const std::size_t last = std::min(cycle + 1 + loads_aside, cycles.size() - 1);
  return first < last ? growth_between(cycles[first].load, cycles[last].load) : 0.0;
}

}  // namespace

std::vector<std::vector<LinerBand>> bands_of(std::span<const WornCycle> cycles, Scheme scheme) {
  std::vector<std::vector<LinerBand>> bands;
  if (cycles.empty()) return bands;
  const WornCycle& first = cycles.front();
  LinerReplicates liners =
      same_liners(first.load.profile, first.deviations.rows(), first.deviations.cols());
  std::vector<TimedLoad> loads;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    const WornCycle& cycle = cycles[i];
    if (i > 0 && cycle.rotation != cycles[i - 1].rotation) {
      liners = mirrored(liners);
      loads.clear();
    }
    loads.push_back(cycle.load);
    const UncertainLoad load{LoadInTime(in_use(loads, scheme)), cycle.deviations,
                             loads.size() > 1 ? cycles[i - 1].deviations : Eigen::MatrixXd(),
                             growth_in(cycles, i)};
    double time = cycle.load.time;
    bands.emplace_back();
    for (const WornStep& step : cycle.steps) {
      liners = worn(liners, load, time, step.duration, step.profile);
      time += step.duration;
      bands.back().push_back(band_after(liners, time));
    }
  }
  return bands;
}

Eigen::VectorXd lives_of(std::span<const WornCycle> cycles,
                         const std::vector<std::vector<LinerBand>>& bands,
                         const CampaignSettings& limits) {
  std::vector<ReplicatesInTime> course;
  double last_load = 0.0;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    if (cycles[i].steps.empty()) continue;
    last_load = cycles[i].load.time;
    if (course.empty()) {
      const auto same = same_liners(cycles[i].load.profile, cycles[i].deviations.rows(),
                                    cycles[i].deviations.cols());
      course.push_back({last_load, lifter_heights(same), plate_thicknesses(same)});
    }
    for (const LinerBand& band : bands[i]) course.push_back(band.replicates);
  }
  return lives(course, limits.height_limit, limits.plate_limit, last_load);
}

}  // namespace millwear::wear
