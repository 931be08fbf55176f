#include "mill/case/operating_change.h"

#include <gmock/gmock.h>

#include <cmath>

#include "mill/case/operated_mill.h"
#include "tests/support/example_case.h"

namespace millwear {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::NanSensitiveDoubleEq;

constexpr double hour = 3600.0;
const double none = std::nan("");

/// Faster after 1000 h, other feed after 1500 h, fuller once the lifter is 30 mm high, and two days
/// at rest after 2000 h.
std::vector<OperatingChange> history() {
  return {{.from_time = 1000.0 * hour, .speed = 4.0},
          {.from_time = 1500.0 * hour, .feed_rate = 20.0},
          {.from_height = 0.030, .counts = {120, 1200, 3600}},
          {.from_time = 2000.0 * hour, .idle_time = 48.0 * hour}};
}

TEST(OperatingChange, BeginsAtItsTimeOrHeight) {
  const auto changes = history();
  EXPECT_THAT(changes_begun(changes, {0.0, 0.040}), IsEmpty());
  EXPECT_THAT(changes_begun(changes, {1000.0 * hour - 0.5, 0.040}), ElementsAre(0));
  EXPECT_THAT(changes_begun(changes, {1000.0 * hour - 1.5, 0.040}), IsEmpty());
  EXPECT_THAT(changes_begun(changes, {0.0, 0.030001}), ElementsAre(2));
  EXPECT_THAT(changes_begun(changes, {0.0, 0.030003}), IsEmpty());
  EXPECT_THAT(changes_begun(changes, {3000.0 * hour, 0.02}), ElementsAre(0, 1, 2, 3));
}

TEST(OperatingChange, AsksForALoadWhereTheChargeMovesOtherwise) {
  const auto changes = history();
  EXPECT_TRUE(asks_for_load(changes[0]));
  EXPECT_FALSE(asks_for_load(changes[1]));
  EXPECT_TRUE(asks_for_load(changes[2]));
  EXPECT_FALSE(asks_for_load(changes[3]));
  EXPECT_TRUE(asks_for_load({.from_time = 0.0, .rotation = Rotation::reversed}));
}

TEST(OperatingChange, LimitsALoadToTheNextThatAsksForOne) {
  const auto changes = history();
  const LoadRange fresh = range_of_load(changes, {100.0 * hour, 0.040});
  EXPECT_DOUBLE_EQ(fresh.time, 900.0 * hour);
  EXPECT_DOUBLE_EQ(fresh.height, 0.030);
  const LoadRange later = range_of_load(changes, {1200.0 * hour, 0.035});
  EXPECT_EQ(later.time, std::numeric_limits<double>::infinity());
  const LoadRange last = range_of_load(changes, {1200.0 * hour, 0.029});
  EXPECT_EQ(last.height, -std::numeric_limits<double>::infinity());
}

TEST(OperatingChange, ReversalsLimitALoadToo) {
  CampaignSettings plan{.height_limit = 0.01, .plate_limit = 0.002};
  plan.operation = history();
  plan.reversal_times = {400.0 * hour};
  EXPECT_DOUBLE_EQ(range_of_load(plan, {100.0 * hour, 0.04}).time, 300.0 * hour);
  EXPECT_NE(operation_in_force(plan, {0.0, 0.04}), operation_in_force(plan, {401.0 * hour, 0.04}));
  EXPECT_EQ(operation_in_force(plan, {1100.0 * hour, 0.04}),
            operation_in_force(plan, {2100.0 * hour, 0.031}));
}

TEST(OperatingChange, BeginsWithinAStep) {
  const auto changes = history();
  const auto begun = begun_hours_after(changes, {}, {1600.0 * hour, 0.0301}, 1600.0);
  EXPECT_THAT(begun,
              ElementsAre(1000.0, 1500.0, NanSensitiveDoubleEq(none), NanSensitiveDoubleEq(none)));
  const auto later = begun_hours_after(changes, begun, {1700.0 * hour, 0.029}, 1700.0);
  EXPECT_THAT(later, ElementsAre(1000.0, 1500.0, 1700.0, NanSensitiveDoubleEq(none)));
}

// 1500 h at 10 kg/s and 1000 h at 20 kg/s; two days at rest from 2000 h on.
TEST(OperatingChange, SumsFeedAndCalendar) {
  const auto changes = history();
  const std::vector begun{1000.0, 1500.0, none, 2000.0};
  EXPECT_DOUBLE_EQ(tonnes_milled(10.0, changes, begun, 1000.0), 36000.0);
  EXPECT_DOUBLE_EQ(tonnes_milled(10.0, changes, begun, 2500.0), 54000.0 + 72000.0);
  EXPECT_TRUE(std::isnan(tonnes_milled({}, changes, begun, 2500.0)));
  EXPECT_TRUE(std::isnan(tonnes_milled({}, {}, {}, 0.0)));
  EXPECT_EQ(tonnes_milled(10.0, {}, {}, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(calendar_hours(changes, begun, 1999.0), 1999.0);
  EXPECT_DOUBLE_EQ(calendar_hours(changes, begun, 2000.0), 2048.0);
}

TEST(OperatedMill, HasWhatTheLastChangeGives) {
  Case mill = example_case();
  mill.feed_rate = 10.0;
  mill.campaign.operation = history();
  const Case operated = as_operated(mill, std::vector<std::size_t>{0, 2});
  EXPECT_EQ(operated.speed, 4.0);
  EXPECT_EQ(operated.feed_rate, 10.0);
  EXPECT_EQ(operated.charge.classes[1].count, 1200u);
  EXPECT_NEAR(filling_inside_plate(operated), 1.2 * filling_inside_plate(mill), 1e-12);
  EXPECT_EQ(as_operated(mill, std::vector<std::size_t>{}).speed, mill.speed);
}

TEST(OperatedMill, TurnsAsTheLastChangeSays) {
  CampaignSettings plan{.height_limit = 0.01, .plate_limit = 0.002};
  plan.operation = {{.from_time = 100.0 * hour, .rotation = Rotation::reversed},
                    {.from_height = 0.03, .rotation = Rotation::as_new}};
  EXPECT_EQ(rotation_at(plan, {0.0, 0.04}), Rotation::as_new);
  EXPECT_EQ(rotation_at(plan, {200.0 * hour, 0.04}), Rotation::reversed);
  EXPECT_EQ(rotation_at(plan, {200.0 * hour, 0.03}), Rotation::as_new);
}

TEST(OperatedMill, IsSpokenOf) {
  Case mill = example_case();
  mill.campaign.operation = history();
  const auto sentences = spoken_operation(mill);
  ASSERT_EQ(sentences.size(), 4u);
  EXPECT_THAT(sentences[0], testing::StartsWith("from 1000 h on 38.20 rpm ("));
  EXPECT_EQ(sentences[1], "from 1500 h on feed 72 t/h");
  EXPECT_THAT(sentences[2], testing::StartsWith("from 30 mm lifter on filling "));
  EXPECT_EQ(sentences[3], "from 2000 h on after 48 h at rest");
}

}  // namespace
}  // namespace millwear
