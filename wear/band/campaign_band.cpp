#include "wear/band/campaign_band.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mill/liner/profile_measures.h"
#include "wear/band/load_scatter.h"

namespace millwear::wear {
namespace {

/// Of the mean that the replicates scatter about being the prediction: zero displacement.
double root_mean_square(const Eigen::VectorXd& deviations) {
  return deviations.norm() / std::sqrt(static_cast<double>(deviations.size()));
}

/// The same scatter about the prediction. The greatest and the least of a noisy profile lie beyond
/// those of its mean, the more the noisier it is: the replicates' extremes beyond the prediction's
/// as the prediction's beyond the truth's.
Eigen::VectorXd centred(const Eigen::VectorXd& replicates, double predicted) {
  return replicates.array() + (predicted - replicates.mean());
}

LinerBand band_after(const LinerReplicates& liners, double time) {
  const double height = lifter_height(liners.profile);
  const double plate = plate_thickness(liners.profile);
  LinerBand band{
      {time, centred(lifter_heights(liners), height), centred(plate_thicknesses(liners), plate)},
      0,
      0,
      0,
      {}};
  band.height_error = root_mean_square(band.replicates.heights.array() - height);
  band.plate_error = root_mean_square(band.replicates.plates.array() - plate);
  band.section_error = root_mean_square(sections_ahead(liners));
  const Eigen::Index bins = liners.deeper.rows();
  band.depth_error = Eigen::VectorXd(bins);
  for (Eigen::Index bin = 0; bin < bins; ++bin) {
    const Eigen::VectorXd deeper = liners.deeper.row(bin);
    band.depth_error[bin] = root_mean_square(deeper);
  }
  return band;
}

/// The cycles that the band of one looks at, all of them of its operation: their liners are one
/// that wears under one charge.
struct Aside {
  std::size_t first;
  std::size_t last;
};

Aside aside_of(std::span<const WornCycle> cycles, std::size_t cycle) {
  const auto goes_on_to = [&](std::size_t next) {
    return cycles[next].continues && cycles[next].rotation == cycles[next - 1].rotation;
  };
  Aside aside{cycle, cycle};
  while (aside.first > 0 && cycle - aside.first < band_looks_aside_before &&
         goes_on_to(aside.first))
    --aside.first;
  while (aside.last + 1 < cycles.size() && aside.last - cycle < band_looks_aside_after &&
         goes_on_to(aside.last + 1))
    ++aside.last;
  return aside;
}

/// Between a load before the cycle's own and one after it: from one to the next, noise would hide
/// the change.
Eigen::VectorXd growth_in(std::span<const WornCycle> cycles, std::size_t cycle) {
  const auto [first, last] = aside_of(cycles, cycle);
  if (first == last) return {};
  return growth_between(cycles[first].load, cycles[last].load, cycles[cycle].load.profile);
}

/// How much more the loads about a cycle scatter than their blocks say.
double scatter_in(std::span<const WornCycle> cycles, std::size_t cycle) {
  const auto [first, last] = aside_of(cycles, cycle);
  std::vector<const TimedLoad*> loads;
  for (std::size_t i = first; i <= last; ++i) loads.push_back(&cycles[i].load);
  return birge_ratio(loads);
}

}  // namespace

CycleBand band_of_cycle(std::span<const WornCycle> cycles, std::size_t i,
                        const LinerReplicates& before, Scheme scheme) {
  const WornCycle& cycle = cycles[i];
  const bool is_turned = i > 0 && cycle.rotation != cycles[i - 1].rotation;
  const bool has_previous = i > 0 && !is_turned && cycle.continues;
  std::vector<TimedLoad> loads;
  if (has_previous) loads.push_back(cycles[i - 1].load);
  loads.push_back(cycle.load);
  const double scatter = scatter_in(cycles, i);
  const UncertainLoad load{LoadInTime(in_use(loads, scheme)), scatter * cycle.deviations,
                           has_previous ? scatter * cycles[i - 1].deviations : Eigen::MatrixXd(),
                           growth_in(cycles, i)};
  CycleBand band{{}, is_turned ? mirrored(before) : before, scatter};
  double time = cycle.load.time;
  for (const WornStep& step : cycle.steps) {
    band.after = worn(band.after, load, time, step.duration, step.profile);
    time += step.duration;
    band.steps.push_back(band_after(band.after, time));
  }
  return band;
}

LinerReplicates first_replicates(const WornCycle& first) {
  return same_liners(first.load.profile, first.deviations.rows(), first.deviations.cols());
}

std::vector<std::vector<LinerBand>> bands_of(std::span<const WornCycle> cycles, Scheme scheme) {
  std::vector<std::vector<LinerBand>> bands;
  if (cycles.empty()) return bands;
  LinerReplicates liners = first_replicates(cycles.front());
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    CycleBand band = band_of_cycle(cycles, i, liners, scheme);
    liners = std::move(band.after);
    bands.push_back(std::move(band.steps));
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
      const auto same = first_replicates(cycles[i]);
      course.push_back({last_load, lifter_heights(same), plate_thicknesses(same)});
    }
    for (const LinerBand& band : bands[i]) course.push_back(band.replicates);
  }
  return lives(course, limits.height_limit, limits.plate_limit, last_load);
}

}  // namespace millwear::wear
