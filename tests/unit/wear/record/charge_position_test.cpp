#include "wear/record/charge_position.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "mill/base/failure.h"

namespace millwear::wear {
namespace {

using std::numbers::pi;

double radians(double degrees) { return degrees * pi / 180.0; }

/// Contacts spread evenly between two angles from six o'clock [deg], and a few in flight.
ChargeAngles charge_between(double from, double to, std::size_t blocks, double wander) {
  auto angles = no_charge_angles(blocks);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> inside(from, to);
  std::uniform_real_distribution<double> anywhere(-180.0, 180.0);
  for (std::size_t block = 0; block < blocks; ++block) {
    const double shift = wander * (block % 2 == 0 ? 1.0 : -1.0);
    for (int i = 0; i < 20000; ++i) {
      add_contact(angles, radians(inside(random) + shift), 1.0, block);
    }
    for (int i = 0; i < 500; ++i) add_contact(angles, radians(anywhere(random)), 1.0, block);
  }
  return angles;
}

// The charge lies from 50 degrees before six o'clock to 140 after it: Morrell's 220 and 50. The
// five-degree mean falls from 1 to 0.1 within 1.8 to 2 degrees outside.
TEST(ChargePosition, IsReportedAsMorrellDoes) {
  const auto position = charge_position(charge_between(-50.0, 140.0, 4, 0.0));
  EXPECT_NEAR(position.toe, radians(220.0), radians(2.5));
  EXPECT_NEAR(position.shoulder, radians(50.0), radians(2.5));
}

// Blocks that stand 3 degrees before and behind in turn: s = 3 sqrt(10 / 9), error s / sqrt(10)
// = 1.
TEST(ChargePosition, ErrorComesFromTheBlocks) {
  const auto position = charge_position(charge_between(-50.0, 140.0, 10, 3.0));
  EXPECT_NEAR(position.toe_error, radians(1.0), radians(0.1));
  EXPECT_NEAR(position.shoulder_error, radians(1.0), radians(0.1));
}

TEST(ChargePosition, AcrossTwelveOClock) {
  const auto position = charge_position(charge_between(-30.0, 179.0, 2, 2.0));
  EXPECT_NEAR(position.shoulder, radians(89.0), radians(5.0));
}

TEST(ChargePosition, IsUnknownWhereTheChargeCentrifuges) {
  const auto position = charge_position(charge_between(-180.0, 180.0, 2, 0.0));
  EXPECT_TRUE(std::isnan(position.toe));
  EXPECT_TRUE(std::isnan(position.shoulder_error));
}

TEST(ChargePosition, NeedsContacts) {
  EXPECT_THROW(static_cast<void>(charge_position(no_charge_angles(2))), ResultRejected);
}

}  // namespace
}  // namespace millwear::wear
