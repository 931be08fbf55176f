#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/verification/wear/synthetic_load.h"
#include "wear/rate/smoothing_error.h"

namespace millwear::wear {
namespace {

constexpr int loads = 200;
constexpr Eigen::Index replicates = 400;
constexpr double least_rate = 0.05;  // of the mean; below it a place counts as unloaded

/// A ball's radius [bins], as on the pilot mill.
constexpr double resolution = 5.0;

/// Shares of the truth in the 95 % band [%], and how wide and how true the rate is at the peaks.
struct Coverage {
  double places = 0.0;
  double peaks = 0.0;
  double corner = 0.0;
  double total = 0.0;
  double half_width = 0.0;  ///< of the band at the broad peaks, over the truth
  double mean_square = 0.0;
};

struct Band {
  double low;
  double high;
  [[nodiscard]] bool holds(double value) const { return low <= value && value <= high; }
};

Band band_of(double value, Eigen::RowVectorXd deviations) {
  std::sort(deviations.begin(), deviations.end());
  const Eigen::Index outside = deviations.size() / 40;
  return {value + deviations[outside], value + deviations[deviations.size() - 1 - outside]};
}

Coverage coverage_of(const SyntheticMill& mill, SmoothingMethod method) {
  Coverage found;
  for (unsigned seed = 1; seed <= loads; ++seed) {
    const auto load = measured(mill, seed);
    const auto loss = smoothed(load.edges, load.rate, load.by_block, {method, resolution});
    const auto& rate = loss.rate.values;
    const Eigen::MatrixXd deviations =
        rate_replicates(loss, replicates, seed, ReplicateOf::noise_and_bias);
    const auto band = [&](Eigen::Index bin) { return band_of(rate[bin], deviations.row(bin)); };
    double places = 0.0;
    double held = 0.0;
    for (Eigen::Index bin = 0; bin < rate.size(); ++bin) {
      if (load.truth[bin] < least_rate) continue;
      places += 1.0;
      held += band(bin).holds(load.truth[bin]) ? 1.0 : 0.0;
    }
    found.places += 100.0 * held / places / loads;
    for (const Eigen::Index peak : load.peaks)
      found.peaks += band(peak).holds(load.truth[peak]) ? 100.0 / 3.0 / loads : 0.0;
    found.corner += band(load.peaks[2]).holds(load.truth[load.peaks[2]]) ? 100.0 / loads : 0.0;
    const Band total = band_of(rate.sum(), deviations.colwise().sum());
    found.total += total.holds(load.truth.sum()) ? 100.0 / loads : 0.0;
    for (const Eigen::Index peak : {load.peaks[0], load.peaks[1]})
      found.half_width += 0.25 * (band(peak).high - band(peak).low) / load.truth[peak] / loads;
    found.mean_square += (rate - load.truth).array().square().mean() / loads;
  }
  return found;
}

class SmoothingCoverage : public testing::TestWithParam<int> {};

void expect_coverage(int blocks, SmoothingMethod method, const char* name) {
  const SyntheticMill mill{.blocks = blocks, .events_in_block = 2000.0 / blocks};
  const auto found = coverage_of(mill, method);
  const std::string row = fmt::format(
      "{:10} {:2} blocks: places {:.1f} %, peaks {:.1f} % (corner {:.1f} %), total {:.1f} %; half "
      "width at the broad peaks {:.2f}, mean square error {:.4f}",
      name, blocks, found.places, found.peaks, found.corner, found.total, found.half_width,
      found.mean_square);
  fmt::print("{}\n", row);
  testing::Test::RecordProperty("coverage", row);
  for (const double share : {found.places, found.peaks, found.total}) {
    EXPECT_GE(share, 90.0);
    EXPECT_LE(share, 99.0);
  }
}

// 2000 collisions in all: the rate of a bin scatters by two thirds from block to block of ten, and
// the total by 12 %, as on the pilot mill.
TEST_P(SmoothingCoverage, OfThe95PercentBandIs90To99Percent) {
  expect_coverage(GetParam(), SmoothingMethod::penalised, "penalised");
}

TEST_P(SmoothingCoverage, OfThePapersSplinesToo) {
  expect_coverage(GetParam(), SmoothingMethod::paper, "paper");
}

/// Mean square error with balls that stay where they are in all blocks, on paths of four bins.
double error_with_locked_balls(double finest) {
  const SyntheticMill mill{.corner_share = 0.0, .locked_share = 0.15, .locked_footprint = 4.0};
  double sum = 0.0;
  for (unsigned seed = 1; seed <= loads; ++seed) {
    const auto load = measured(mill, seed);
    const auto loss =
        smoothed(load.edges, load.rate, load.by_block, {SmoothingMethod::penalised, finest});
    sum += (loss.rate.values - load.truth).array().square().mean() / loads;
  }
  return sum;
}

// Neither cross-validation sees noise that is the same in all blocks and in neighbouring bins.
TEST(SmoothingResolution, KeepsLockedBallsFromLookingLikeShape) {
  const double limited = error_with_locked_balls(resolution);
  const double free = error_with_locked_balls(0.0);
  fmt::print("locked balls: mean square error {:.4f}, without the limit {:.4f}\n", limited, free);
  EXPECT_LT(limited, 0.95 * free);
}

INSTANTIATE_TEST_SUITE_P(TimeBlocks, SmoothingCoverage, testing::Values(5, 10, 50));

}  // namespace
}  // namespace millwear::wear
