#include <gtest/gtest.h>

#include "recorder/options/mixing_options.h"
#include "recorder/options/recording_plan.h"
#include "recorder/options/run_options.h"

namespace millwear::recorder {
namespace {

RecordingPlan plain() {
  return {
      "deck.in", "../../case.lock.toml", "../mesh/profile.csv", "load.h5", {}, {}, 100, 300, 1, {},
      {}};
}

RecordingPlan full() {
  RecordingPlan plan = plain();
  plan.events = "events with a blank.h5";
  plan.charge = "charge.h5";
  plan.every_steps = 10;
  plan.pairs_after = 250;
  plan.going_on = GoingOn{1.0 / 30.0, 50, 500};
  return plan;
}

RecordingPlan part() {
  RecordingPlan plan = plain();
  plan.measured_before = 0;
  plan.block_steps = 1000;
  plan.columns = 4;
  return plan;
}

std::vector<std::string> behind_verb(std::vector<std::string> words, const char* verb) {
  EXPECT_EQ(words.front(), verb);
  words.erase(words.begin());
  return words;
}

// The target is told to the last bit.
TEST(RecorderOrders, OfARecordingComeBackFromTheirWords) {
  EXPECT_EQ(recording_plan(to_arguments(plain())), plain());
  EXPECT_EQ(recording_plan(to_arguments(full())), full());
  EXPECT_EQ(recording_plan(to_arguments(part())), part());
}

TEST(RecorderOrders, OfAMixingComeBackFromTheirWords) {
  const MixingOptions options{"deck.in", "mixing.csv", {100, 400, 2400, 1200}, 8};
  EXPECT_EQ(mixing_options(behind_verb(to_arguments(options), mixing_verb)), options);
}

TEST(RecorderOrders, OfARunComeBackFromTheirWords) {
  const DeckRunOptions options{"deck.in", 2};
  EXPECT_EQ(run_options(behind_verb(to_arguments(options), running_verb)), options);
}

}  // namespace
}  // namespace millwear::recorder
