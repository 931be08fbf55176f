#include "orchestrator/results/life_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mill/base/constants.h"
#include "wear/band/life_band.h"

namespace millwear::orchestrator {
namespace {

constexpr double longest_factor = 4.0;

double relative_scatter(const Eigen::VectorXd& lives) {
  const double mean = lives.mean();
  return std::sqrt((lives.array() - mean).square().mean()) / mean;
}

}  // namespace

Eigen::VectorXd lives_of(const Case& mill, const std::vector<CycleResults>& cycles) {
  std::vector<wear::ReplicatesInTime> course;
  double last_load = 0.0;
  for (const auto& cycle : cycles) {
    if (cycle.step_durations.empty()) continue;
    last_load = cycle.load_time;
    double time = cycle.load_time;
    std::size_t row = cycle.replicates.size() - cycle.step_durations.size();
    if (course.empty()) {
      const auto& fresh = cycles.front().replicates.front();
      course.push_back({time, fresh.heights, fresh.plates});
    }
    for (const double duration : cycle.step_durations) {
      const auto& after = cycle.replicates[row++];
      time += duration;
      course.push_back({time, after.heights, after.plates});
    }
  }
  if (course.empty()) return {};
  const auto& limits = mill.campaign;
  return wear::lives(course, limits.height_limit, limits.plate_limit, last_load) / seconds_per_hour;
}

double length_ratio(const LifeErrorSoFar& so_far, double target) {
  const double spent = so_far.relative_error * so_far.relative_error;
  const double left = std::pow(target / errors_of_95_percent, 2) - spent;
  if (!(left > 0.0)) return std::numeric_limits<double>::infinity();
  return spent * (1.0 - so_far.share_of_life) / so_far.share_of_life / left;
}

double revolutions_of_next_load(const Campaign& campaign, const Ledger& ledger) {
  const auto& mill = campaign.mill;
  const double least = mill.dem.measure_revolutions;
  if (!mill.campaign.target_life_error) return least;
  const auto loads = loads_of_cycles(campaign, ledger);
  if (loads.empty()) return least;
  const auto cycles = results_of_cycles(campaign, ledger, loads);
  double revolutions = 0.0;
  for (const CycleResults& cycle : cycles) revolutions += cycle.conservation.revolutions;
  const LifeErrorSoFar so_far{relative_scatter(lives_of(mill, cycles)),
                              share_of_life(mill, cycles.back().after.liner)};
  return std::clamp(revolutions / static_cast<double>(cycles.size()) *
                        length_ratio(so_far, *mill.campaign.target_life_error),
                    least, longest_factor * least);
}

std::optional<std::string> life_error_warning(const Case& mill, const Life& life) {
  const auto target = mill.campaign.target_life_error;
  if (!target || !life.reached || !std::isfinite(life.hours_low)) return std::nullopt;
  const double half_width = 0.5 * (life.hours_high - life.hours_low) / life.hours;
  if (half_width <= *target) return std::nullopt;
  return fmt::format(
      "the life is known to +-{:.1f} % and not to the {:.3g} % of `target_life_error`; raise "
      "`measure_revolutions`, of which a load takes four times at most",
      100.0 * half_width, 100.0 * *target);
}

}  // namespace millwear::orchestrator
