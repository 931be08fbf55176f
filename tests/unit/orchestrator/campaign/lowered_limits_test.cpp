#include "orchestrator/campaign/lowered_limits.h"

#include <gtest/gtest.h>

#include "tests/support/example_case.h"

namespace millwear::orchestrator {
namespace {

Ledger ended_by(Outcome outcome) {
  return {
      {"millwear", "old", 2, "host"},
      {{{4, StageKind::dem}, Outcome::go_on, {}, 1.0}, {{4, StageKind::wear}, outcome, {}, 1.0}}};
}

TEST(OnlyLowersLimits, OfHeightAndPlateAndAnyNumberOfCycles) {
  const Case there = example_case();
  Case here = there;
  EXPECT_TRUE(only_lowers_limits(here, there));
  here.campaign.height_limit -= 0.1;
  here.campaign.plate_limit *= 0.5;
  here.campaign.cycle_limit *= 3;
  EXPECT_TRUE(only_lowers_limits(here, there));
  EXPECT_FALSE(only_lowers_limits(there, here));
}

TEST(OnlyLowersLimits, NotWhereOneIsHigherOrAnythingElseIsOther) {
  const Case there = example_case();
  Case here = there;
  here.campaign.height_limit -= 0.001;
  here.campaign.plate_limit += 0.001;
  EXPECT_FALSE(only_lowers_limits(here, there));
  here = there;
  here.campaign.height_limit -= 0.001;
  here.dem.seed += 1;
  EXPECT_FALSE(only_lowers_limits(here, there));
}

TEST(Reopened, IsWithoutTheWearThatEndedAtALimit) {
  for (const Outcome limit : {Outcome::height_limit, Outcome::plate_limit}) {
    const Ledger ledger = reopened(ended_by(limit), "new");
    EXPECT_EQ(ledger.start.case_hash, "new");
    EXPECT_EQ(ledger.start.ranks, 2);
    ASSERT_EQ(ledger.entries.size(), 1u);
    EXPECT_EQ(ledger.entries.back().stage.kind, StageKind::dem);
  }
}

TEST(Reopened, KeepsWhatDidNotEndAtALimit) {
  for (const Outcome outcome : {Outcome::go_on, Outcome::reversed})
    EXPECT_EQ(reopened(ended_by(outcome), "new").entries.size(), 2u);
}

}  // namespace
}  // namespace millwear::orchestrator
