#include "orchestrator/dem_run/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace millwear::orchestrator {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::EndsWith;
using ::testing::StartsWith;

TEST(SpokenTime, TakesTheTwoLargestUnits) {
  EXPECT_EQ(spoken_time(0.4), "0 s");
  EXPECT_EQ(spoken_time(12.0), "12 s");
  EXPECT_EQ(spoken_time(200.0), "3 min 20 s");
  EXPECT_EQ(spoken_time(3900.0), "1 h 05 min");
  EXPECT_EQ(spoken_time(100.0 * 3600.0), "100 h 00 min");
}

// 59.6 s are a minute, not "60 s".
TEST(SpokenTime, RoundsBeforeItChoosesTheUnit) {
  EXPECT_EQ(spoken_time(59.6), "1 min 00 s");
  EXPECT_EQ(spoken_time(3599.6), "1 h 00 min");
}

TEST(Progress, PrintsNothingWhenQuiet) {
  testing::internal::CaptureStderr();
  {
    Progress progress(Verbosity::quiet);
    progress.begin("cycle 0 dem", 0.0, 0.2);
    progress.advance(0.5);
    progress.say("cycle 0: worn");
    progress.end();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

// Mixing takes the liner nowhere, so the time it takes (nearly 2 s here) says nothing of the time
// that is left, and is not in it.
TEST(Progress, TellsTheTimeLeftOfPiecesThatGainSomething) {
  testing::internal::CaptureStderr();
  {
    Progress progress(Verbosity::normal, std::chrono::seconds(0));
    progress.begin("cycle 0 mix", 0.0, 0.0);
    progress.advance(0.9);
    std::this_thread::sleep_for(std::chrono::milliseconds(1700));
    progress.begin("cycle 0 dem", 0.0, 1.0);
    progress.advance(0.5);
  }
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              AllOf(StartsWith("  cycle 0 mix: 90 %\n  cycle 0 dem: 50 %  about "),
                    AnyOf(EndsWith(" 0 s left\n"), EndsWith(" 1 s left\n"))));
}

TEST(Progress, TellsDetailsOnlyToThoseWhoAsked) {
  testing::internal::CaptureStderr();
  Progress(Verbosity::normal).detail("cycle 0 mesh took 0.1 s");
  Progress(Verbosity::verbose).detail("cycle 0 mix took 1 s");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "cycle 0 mix took 1 s\n");
}

}  // namespace
}  // namespace millwear::orchestrator
