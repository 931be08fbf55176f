#include "wear/band/load_scatter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/sample_profiles.h"
#include "wear/numerics/random_stream.h"

namespace millwear::wear {
namespace {

constexpr Eigen::Index bins = 120;
constexpr Eigen::Index blocks = 10;

/// A load whose bins scatter by `noise` from block to block, all of it off by `offset` and grown to
/// 1 + `trend` times its time.
TimedLoad load_at(double time, double noise, double offset, double trend, std::uint64_t seed) {
  const auto ring = bare_ring();
  const Eigen::MatrixXd by_block =
      ((1.0 + offset + trend * time) * (1.0 + noise * standard_normals(bins, blocks, seed).array()))
          .matrix();
  return {time,
          ring,
          {Eigen::VectorXd::LinSpaced(bins + 1, 0.0, arc_lengths(ring).back()),
           by_block.rowwise().mean()},
          by_block};
}

double ratio_of(const std::vector<TimedLoad>& loads) {
  std::vector<const TimedLoad*> all;
  for (const TimedLoad& load : loads) all.push_back(&load);
  return birge_ratio(all);
}

// Loads that grow evenly and scatter as their blocks do: 58 x 12 squares of Student's t with a
// variance of 9 / 7 at most.
TEST(BirgeRatio, OfLoadsThatScatterAsTheirBlocksIsOne) {
  std::vector<TimedLoad> loads;
  for (int i = 0; i < 60; ++i)
    loads.push_back(load_at(i, 0.3, 0.0, 0.05, 100 + static_cast<std::uint64_t>(i)));
  EXPECT_LT(ratio_of(loads), 1.15);
}

// What lies still for a measurement is in no block of it: here as much again as the zones' noise.
TEST(BirgeRatio, SeesWhatNoBlockShows) {
  const double noise = 0.3;
  const double of_zone = noise / std::sqrt(10.0 * static_cast<double>(blocks));
  std::vector<TimedLoad> loads;
  const Eigen::MatrixXd offsets = standard_normals(60, 1, 3);
  for (int i = 0; i < 60; ++i)
    loads.push_back(
        load_at(i, noise, of_zone * offsets(i, 0), 0.0, 200 + static_cast<std::uint64_t>(i)));
  EXPECT_NEAR(ratio_of(loads), std::sqrt(2.0), 0.2);
}

TEST(BirgeRatio, OfTwoLoadsOrExactOnesIsOne) {
  EXPECT_EQ(ratio_of({load_at(0.0, 0.3, 0.0, 0.0, 1), load_at(1.0, 0.3, 0.5, 0.0, 2)}), 1.0);
  std::vector<TimedLoad> exact{load_at(0.0, 0.0, 0.0, 0.0, 1), load_at(1.0, 0.0, 0.5, 0.0, 2),
                               load_at(2.0, 0.0, 0.0, 0.0, 3)};
  for (TimedLoad& load : exact) load.by_block.resize(0, 0);
  EXPECT_EQ(ratio_of(exact), 1.0);
}

}  // namespace
}  // namespace millwear::wear
