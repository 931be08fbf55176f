#include "orchestrator/dem_run/rank_cost.h"

#include <gtest/gtest.h>

#include "tests/support/example_case.h"

namespace millwear::orchestrator {
namespace {

/// 4,100 particles up to 50 mm in a slice of 0.2 m.
Case recorded_case() {
  Case mill = example_case();
  mill.dem.contact_path = ContactPath::recorder;
  return mill;
}

TEST(RankCost, OfOneRankHasThePeriodicImagesAlone) {
  const RankCost cost = rank_cost(recorded_case(), 1);
  EXPECT_EQ(cost.particles, 4100.0);
  EXPECT_DOUBLE_EQ(cost.ghosts, 2.0 * 0.05 / 0.2);
  EXPECT_EQ(cost.imbalance, 1.0);
}

// Two columns of a charge 0.7 m wide, with one cut between them.
TEST(RankCost, OfTwoRanksHasTheCutBesides) {
  const RankCost cost = rank_cost(recorded_case(), 2);
  EXPECT_EQ(cost.columns, 2);
  EXPECT_EQ(cost.slabs, 1);
  EXPECT_DOUBLE_EQ(cost.ghosts, 1.5 * (1.0 + 2.0 * 0.05 / 0.7) - 1.0);
}

TEST(RankCost, FallsWithTheRanksAndItsCoreTimeRises) {
  Case mill = recorded_case();
  for (auto& kind : mill.charge.classes) kind.count *= 100;
  mill.slice_length *= 100.0;
  RankCost before = rank_cost(mill, 1);
  for (const int ranks : {2, 4, 8, 16, 32}) {
    const RankCost cost = rank_cost(mill, ranks);
    EXPECT_LT(cost.step_seconds, before.step_seconds) << ranks;
    EXPECT_GE(cost.ghosts, before.ghosts) << ranks;
    before = cost;
  }
}

// Twice the mill on twice the ranks: the same ghosts and the same step.
TEST(RankCost, OfALongerMillOnAsManyMoreRanksIsTheSame) {
  Case mill = recorded_case();
  mill.dem.rank_split = RankSplit::axis;
  mill.slice_length = 2.0;
  const RankCost once = rank_cost(mill, 2);
  mill.slice_length = 4.0;
  for (auto& kind : mill.charge.classes) kind.count *= 2;
  const RankCost twice = rank_cost(mill, 4);
  EXPECT_DOUBLE_EQ(twice.ghosts, once.ghosts);
  EXPECT_DOUBLE_EQ(twice.step_seconds, once.step_seconds);
  EXPECT_DOUBLE_EQ(twice.memory, 2.0 * once.memory);
}

}  // namespace
}  // namespace millwear::orchestrator
