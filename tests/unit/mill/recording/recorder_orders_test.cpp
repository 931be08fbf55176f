#include "mill/recording/recorder_orders.h"

#include <gmock/gmock.h>

namespace millwear {
namespace {

using testing::ElementsAre;

TEST(RecorderOrders, SampleEveryMultipleAfterTheFirstStep) {
  RecordingPlan plan{};
  plan.first_step = 100;
  plan.last_step = 300;
  EXPECT_EQ(samples_between(plan, 100, 300), 200);
  plan.every_steps = 30;
  EXPECT_EQ(samples_between(plan, 100, 300), 7);  // 130, 160, ... 280, 300
}

// What is not wanted is not told.
TEST(RecorderOrders, AreWordsOfACommandLine) {
  const RecordingPlan plan{"deck.in", "case.toml", "liner.csv", "load.h5", {}, {},
                           100,       300,         2,           {},        {}};
  EXPECT_THAT(to_arguments(plan),
              ElementsAre("--in", "deck.in", "--case", "case.toml", "--liner", "liner.csv",
                          "--load", "load.h5", "--after", "100", "--until", "300", "--every", "2"));
  EXPECT_THAT(to_arguments(DeckRunOptions{"deck.in"}), ElementsAre("run", "--in", "deck.in"));
  EXPECT_THAT(to_arguments(MixingOptions{"deck.in", "mixing.csv", {100, 400, 2400, 1200}}),
              ElementsAre("mix", "--in", "deck.in", "--record", "mixing.csv", "--piece", "100",
                          "--after", "400", "--at-most", "2400", "--revolution", "1200"));
}

}  // namespace
}  // namespace millwear
