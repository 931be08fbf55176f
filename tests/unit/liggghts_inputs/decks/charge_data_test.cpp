#include "liggghts_inputs/decks/charge_data.h"

#include <gmock/gmock.h>

#include <numbers>

#include "tests/support/example_case.h"

namespace millwear::liggghts {
namespace {

using ::testing::EndsWith;
using ::testing::StartsWith;

TEST(LevelForArea, HoldsHalfOfTheCircleAtItsMiddle) {
  EXPECT_NEAR(level_for_area(2.0, 2.0 * std::numbers::pi), 0.0, 1e-5);
  EXPECT_NEAR(level_for_area(2.0, 4.0 * std::numbers::pi), 2.0, 1e-5);
}

TEST(ChargeDataFile, HoldsTheChargeInABoxAroundTheShell) {
  const Case mill = example_case();
  const auto text = charge_data_file(mill, {{{0.1, 0.05, -0.4}, 0}, {{-0.1, 0.15, -0.3}, 2}});
  EXPECT_THAT(text, StartsWith("# charge of example\n\n2 atoms\n2 atom types\n-"));
  EXPECT_THAT(text, EndsWith(" 0.5304 xlo xhi\n0 0.2 ylo yhi\n-0.5304 0.5304 zlo zhi\n\nAtoms\n\n"
                             "1 1 0.05 7800 0.1 0.05 -0.4\n2 2 0.02 2700 -0.1 0.15 -0.3\n"));
}

TEST(ChargeDataFile, HoldsVelocitiesOfAChargeInMotion) {
  const auto text = charge_data_file(
      example_case(), {{{0.1, 0.05, -0.4}, 0, {1, 2, 3}, {4, 5, 6}}, {{-0.1, 0.15, -0.3}, 2}});
  EXPECT_THAT(text, EndsWith("2 2 0.02 2700 -0.1 0.15 -0.3\n\nVelocities\n\n1 1 2 3 4 5 6\n"
                             "2 0 0 0 0 0 0\n"));
}

// The centroid of a half-filled circle is 4 R / 3 pi from its centre; it is carried up to 0.83 of
// that beside the axis, and the box's middle is there.
TEST(ChargeDataFile, HasTheMovingChargeInItsMiddle) {
  Case mill = example_case();
  const double share = 0.5 / computed_filling(mill);
  for (auto& kind : mill.charge.classes)
    kind.count = static_cast<std::size_t>(static_cast<double>(kind.count) * share);
  const auto text = charge_data_file(mill, {});
  const double low = std::stod(text.substr(text.find("types\n") + 6));
  const double centroid = 4.0 * mill.liner.sector.plate_radius / (3.0 * std::numbers::pi);
  EXPECT_NEAR(0.5 * (low + 0.5304), -0.83 * centroid, 0.02 * centroid);
}

}  // namespace
}  // namespace millwear::liggghts
