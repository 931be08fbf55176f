#include "mill/recording/recorder_lines.h"

#include <gtest/gtest.h>

namespace millwear {
namespace {

const MeasuringLine going_on{4000, 0.071, 0.05, NextEnd{5000, 8000}};
const MeasuringLine ending{9000, 0.048, 0.05, {}};
const MixingLine drifting{800, MixingDrift{{0.021, 0.05}, {0.008, 0.05}}};

void expect_same(const std::optional<MeasuringLine>& read, const MeasuringLine& line) {
  ASSERT_TRUE(read);
  EXPECT_EQ(read->step, line.step);
  EXPECT_DOUBLE_EQ(read->peak_error, line.peak_error);
  EXPECT_DOUBLE_EQ(read->target_error, line.target_error);
  EXPECT_EQ(read->next, line.next);
}

TEST(MeasuringLine, SaysWhatIsKnownAndWhatFollows) {
  EXPECT_EQ(printed(going_on),
            "millwear: step 4000, rate at its peaks known to 7.1 % (target 5 %), going on to step "
            "5000, perhaps to 8000");
  EXPECT_EQ(printed(ending),
            "millwear: step 9000, rate at its peaks known to 4.8 % (target 5 %), the measurement "
            "ends");
}

TEST(MeasuringLine, IsReadBack) {
  expect_same(measuring_line(printed(going_on)), going_on);
  expect_same(measuring_line(printed(ending)), ending);
}

TEST(MeasuringLine, IsNoLineOfAnotherKind) {
  EXPECT_FALSE(measuring_line(""));
  EXPECT_FALSE(measuring_line("    4000 120 0.5 0.1 -3.2"));
  EXPECT_FALSE(measuring_line(printed(drifting)));
  EXPECT_FALSE(measuring_line(printed(going_on).substr(0, 90)));
  EXPECT_FALSE(measuring_line(printed(ending) + "?"));
}

TEST(MixingLine, IsReadBack) {
  EXPECT_EQ(printed(drifting),
            "millwear: step 800, torque drifts by 2.1 % (limit 5 %), kinetic energy by 0.8 % "
            "(limit 5 %)");
  const auto read = mixing_line(printed(drifting));
  ASSERT_TRUE(read && read->drift);
  EXPECT_EQ(read->step, 800);
  EXPECT_DOUBLE_EQ(read->drift->torque.relative, 0.021);
  EXPECT_DOUBLE_EQ(read->drift->kinetic_energy.limit, 0.05);
  const auto early = mixing_line(printed(MixingLine{100, {}}));
  ASSERT_TRUE(early);
  EXPECT_EQ(early->step, 100);
  EXPECT_FALSE(early->drift);
}

TEST(MixingLine, IsNoLineOfAnotherKind) {
  EXPECT_FALSE(mixing_line("millwear: stretch complete"));
  EXPECT_FALSE(mixing_line(printed(going_on)));
  EXPECT_FALSE(mixing_line("millwear: step many, too early to tell a drift"));
}

}  // namespace
}  // namespace millwear
