#include "orchestrator/results/uncertainty.h"

#include <algorithm>
#include <cmath>

#include "mill/liner/profile_measures.h"
#include "orchestrator/campaign/kept_cycle.h"
#include "wear/numerics/arc_curve.h"
#include "wear/numerics/random_stream.h"
#include "wear/rate/smoothing_error.h"

namespace millwear::orchestrator {
namespace {

constexpr Eigen::Index replicates = 200;
constexpr double seconds_per_hour = 3600.0;

/// A value of even bins along a profile at each of its nodes.
std::vector<double> at_nodes(const LinerProfile& profile, const Eigen::VectorXd& by_bin) {
  const auto lengths = arc_lengths(profile);
  const wear::ArcCurve curve{Eigen::VectorXd::LinSpaced(by_bin.size() + 1, 0.0, lengths.back()),
                             by_bin};
  std::vector<double> values;
  for (const double arc_length : lengths) values.push_back(curve.at(arc_length));
  return values;
}

/// The new liner, the same for all replicates, as a row before the steps.
void begin_replicates(const Case& mill, CampaignResults& data) {
  data.replicates = {{0, 0, 0.0, Eigen::VectorXd::Constant(replicates, lifter_height(mill.liner)),
                      Eigen::VectorXd::Constant(replicates, plate_thickness(mill.liner))}};
}

}  // namespace

wear::WornCycle worn_cycle(const Campaign& campaign, int cycle, double time,
                           const wear::LoadRate& rate, const KeptCycle& kept) {
  const auto seed = wear::random_bits(campaign.mill.dem.seed, static_cast<std::uint64_t>(cycle));
  wear::WornCycle worn{timed_load(campaign, cycle, time, rate),
                       wear::rate_replicates(rate.smoothed, replicates, seed),
                       {},
                       rotation_of_cycle(campaign, cycle)};
  for (const auto& step : kept.steps)
    worn.steps.push_back({step.duration, as_turned(step.profile, worn.rotation)});
  return worn;
}

void add_uncertainty(const Case& mill, const std::vector<wear::WornCycle>& cycles,
                     CampaignResults& data) {
  const auto bands = wear::bands_of(cycles, mill.campaign.scheme);
  if (!data.history.empty()) begin_replicates(mill, data);
  std::size_t row = 1;
  for (std::size_t cycle = 0; cycle < bands.size(); ++cycle)
    for (std::size_t step = 0; step < bands[cycle].size(); ++step, ++row) {
      const auto& band = bands[cycle][step];
      auto& history = data.history.at(row);
      history.lifter_height_error = band.height_error;
      history.plate_thickness_error = band.plate_error;
      history.worn_volume_error = band.section_error;
      data.replicates.push_back({history.cycle, history.step, history.operating_hours,
                                 band.replicates.heights, band.replicates.plates});
      data.profiles.at(row).depth_error = as_turned(
          at_nodes(cycles[cycle].steps[step].profile, band.depth_error), cycles[cycle].rotation);
    }
  if (!data.life.reached) return;
  const auto life = wear::band_of(wear::lives_of(cycles, bands, mill.campaign) / seconds_per_hour);
  data.life.hours_low = life.low;
  data.life.hours_high = life.high;
}

}  // namespace millwear::orchestrator
