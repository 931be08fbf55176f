#include "wear/evolve/step_control.h"

#include <algorithm>
#include <cmath>

#include "mill/base/contract.h"

namespace millwear::wear {
namespace {

constexpr double safety = 0.9;
constexpr double clearly = 2.0;
constexpr double most_growth = 2.0;
constexpr double most_shrinkage = 0.5;

}  // namespace

StepError step_error(std::span<const TimedLoad> loads, double new_lifter_area) {
  expect(loads.size() >= 2, "the error of a step takes a load before it and one after it");
  const TimedLoad& after = loads.back();
  const auto before = loads.first(loads.size() - 1);
  const ZonedLoad predicted = LoadInTime(before).predicted(after.profile, after.time);
  const ZonedLoad found = zoned(after, after.profile);
  const double difference = (found.rate - predicted.rate).squaredNorm();
  const double noise = (found.variance + predicted.variance).sum();
  const double worn_share =
      section_rate(after) * (after.time - before.back().time) / new_lifter_area;
  const double misplaced =
      std::sqrt(std::max(0.0, difference - clearly * noise)) / found.rate.norm();
  return {worn_share, 0.5 * worn_share * misplaced};
}

double time_to_next_load(std::span<const TimedLoad> loads, double new_lifter_area,
                         const CampaignSettings& settings) {
  expect(!loads.empty(), "the time to the next load takes one load or more");
  const double per_second = section_rate(loads.back()) / new_lifter_area;
  const double longest = settings.largest_share / per_second;
  if (loads.size() == 1) {
    return std::min(longest, 0.5 * std::sqrt(2.0 * settings.step_tolerance) / per_second);
  }
  const double last = loads.back().time - loads[loads.size() - 2].time;
  const double order = loads.size() == 2 ? 1.0 : 2.0;
  const double misplaced = step_error(loads, new_lifter_area).misplaced;
  const double wanted = safety * std::pow(settings.step_tolerance / misplaced, 1.0 / (order + 1.0));
  return std::min(longest, last * std::clamp(wanted, most_shrinkage, most_growth));
}

}  // namespace millwear::wear
