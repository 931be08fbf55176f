#include "orchestrator/results/life_error.h"

#include <gmock/gmock.h>

#include <cmath>

#include "mill/case_file/case_file.h"

namespace millwear::orchestrator {
namespace {

using testing::HasSubstr;

constexpr double normal_95 = 1.96;

// A standard error of 1 % by the first quarter: the other three of as long loads make 2 % in all.
TEST(LengthRatio, IsOneWhereLoadsOfTheSameLengthReachTheTarget) {
  EXPECT_NEAR(length_ratio({0.01, 0.25}, normal_95 * 0.02), 1.0, 1e-12);
}

// Of 4e-4, 1e-4 is spent, and three times 1e-4 are to come; half the target leaves nothing.
TEST(LengthRatio, GoesWithTheInverseOfTheVarianceThatIsLeft) {
  EXPECT_NEAR(length_ratio({0.01, 0.25}, normal_95 * std::sqrt(2.5e-4)), 2.0, 1e-12);
  EXPECT_EQ(length_ratio({0.01, 0.25}, normal_95 * 0.01), std::numeric_limits<double>::infinity());
}

TEST(LengthRatio, IsNothingAtTheEndOfALife) {
  EXPECT_EQ(length_ratio({0.01, 1.0}, normal_95 * 0.02), 0.0);
}

class LifeError : public testing::Test {
 protected:
  LifeError() { mill.campaign.target_life_error = 0.05; }
  Case mill = read_case(std::filesystem::path(MILLWEAR_CASES) / "pilot_mill" / "case.toml");
};

TEST_F(LifeError, WarnsWhereTheLifeIsNotKnownAsWellAsWanted) {
  const Life life{true, 1000.0, 940.0, 1060.0, std::nan(""), ""};
  const auto warning = life_error_warning(mill, life);
  ASSERT_TRUE(warning);
  EXPECT_THAT(*warning, HasSubstr("+-6.0 % and not to the 5 %"));
}

TEST_F(LifeError, SaysNothingOfALifeThatIsKnownOrNotReachedOrNotAskedFor) {
  EXPECT_FALSE(life_error_warning(mill, {true, 1000.0, 960.0, 1040.0, std::nan(""), ""}));
  EXPECT_FALSE(life_error_warning(mill, {false, 1000.0, 900.0, 1100.0, std::nan(""), ""}));
  mill.campaign.target_life_error.reset();
  EXPECT_FALSE(life_error_warning(mill, {true, 1000.0, 900.0, 1100.0, std::nan(""), ""}));
}

TEST_F(LifeError, OfACampaignWithoutLoadsAsksForTheLeast) {
  const Campaign campaign{mill, {"no/such/folder"}, 1};
  EXPECT_EQ(revolutions_of_next_load(campaign, {}), mill.dem.measure_revolutions);
}

}  // namespace
}  // namespace millwear::orchestrator
