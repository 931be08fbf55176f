#include "orchestrator/export/published_campaign.h"

#include <gmock/gmock.h>

#include "mill/base/constants.h"
#include "mill/base/failure.h"
#include "tests/support/example_case.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

using testing::HasSubstr;

/// Two cycles: the new liner and two steps of 100 h, then one of 50 h. Heights tell them apart.
PublishedCampaign two_cycles() {
  PublishedCampaign published{{example_case(), {"nowhere"}, 1}, std::nullopt, {}};
  const auto add = [&](int cycle, int step, double hours) {
    published.profiles.push_back({cycle, step, hours, {{-0.1, 0.0}, {0.0, hours}, {0.1, 0.0}}, {}});
  };
  add(0, 0, 0.0);
  add(0, 1, 100.0);
  add(0, 2, 200.0);
  add(1, 1, 250.0);
  return published;
}

double hours_after(std::optional<int> cycle, std::optional<int> step) {
  return profile_after(two_cycles(), cycle, step).operating_hours;
}

TEST(ProfileAfter, IsTheLatestUnlessAskedFor) {
  EXPECT_EQ(hours_after({}, {}), 250.0);
  EXPECT_EQ(hours_after(0, {}), 200.0);
  EXPECT_EQ(hours_after(0, 0), 0.0);
  EXPECT_EQ(hours_after({}, 1), 250.0);
}

TEST(ProfileAfter, SaysWhichThereAre) {
  const auto refusal = [](std::optional<int> cycle, std::optional<int> step) {
    try {
      static_cast<void>(hours_after(cycle, step));
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.exit_code, ExitCode::usage);
      return std::string(failure.what());
    }
    return std::string();
  };
  EXPECT_THAT(refusal(2, {}), HasSubstr("--cycle 2: nowhere has no profile of this cycle; there "
                                        "are cycles 0 to 1"));
  EXPECT_THAT(refusal(0, 3), HasSubstr("--at-step 3: nowhere has no such step; cycle 0 has steps "
                                       "0 to 2"));
  EXPECT_THAT(refusal({}, 0), HasSubstr("cycle 1 has step 1 alone"));
  EXPECT_THAT(refusal(-1, {}), HasSubstr("--cycle -1"));
}

TEST(StartOfACycle, IsTheLastLinerBeforeIt) {
  const PublishedCampaign published = two_cycles();
  EXPECT_EQ(cycles_begun(published), 3);
  EXPECT_EQ(start_of(published, 0).operating_hours, 0.0);
  EXPECT_EQ(start_of(published, 1).operating_hours, 200.0);
  EXPECT_EQ(start_of(published, 2).operating_hours, 250.0);
  EXPECT_EQ(start_of(published, 1).liner.nodes[1].y(), 200.0);
}

TEST(StartOfACycle, TurnsAsTheCaseSays) {
  PublishedCampaign published = two_cycles();
  published.campaign.mill.campaign.reversal_times = {200.0 * seconds_per_hour};
  EXPECT_EQ(start_of(published, 0).rotation, Rotation::as_new);
  EXPECT_EQ(start_of(published, 1).rotation, Rotation::reversed);
}

TEST(PublishedCampaign, WithoutALedgerHasNeitherLoadsNorCharge) {
  EXPECT_FALSE(load_of(two_cycles(), 0));
  EXPECT_FALSE(frames_of(two_cycles(), 0));
}

}  // namespace
}  // namespace millwear::orchestrator
