#include "orchestrator/pictures/liner_section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mill/liner/profile_measures.h"
#include "tests/support/sample_profiles.h"

namespace millwear::orchestrator {
namespace {

using wear::square_lifter;

double area(const Outline& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto& a = outline[i];
    const auto& b = outline[(i + 1) % outline.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * std::abs(twice);
}

// The shell's arc is drawn as twelve chords, which leaves out 0.4 % of this steel.
TEST(LinerSection, OutlinesHoldTheSteelOfEveryRow) {
  const LinerProfile liner = square_lifter();
  const auto outlines = steel_outlines(liner, 0.3);
  ASSERT_EQ(outlines.size(), 10U);
  for (const Outline& outline : outlines)
    EXPECT_NEAR(area(outline), steel_area(liner), 5e-3 * steel_area(liner));
}

// At mill angle 90 degrees lifter 0 stands at nine o'clock, on the side that rises.
TEST(LinerSection, LiftersTurnWithTheMill) {
  const auto outlines = steel_outlines(square_lifter(), M_PI / 2.0);
  double innermost = 2.0;
  for (const auto& place : outlines[0]) {
    EXPECT_LT(place.x(), 0.0);
    innermost = std::min(innermost, place.norm());
  }
  EXPECT_NEAR(innermost, std::hypot(0.05, 0.9), 1e-9);
}

TEST(LinerSection, TheCutLinerReachesFromOneEndOfTheSliceToTheOther) {
  double least = 1.0;
  double most = 0.0;
  for (const Triangle& triangle : cut_liner(square_lifter(), 0.0, 0.25))
    for (const auto& corner : triangle.corners) {
      least = std::min(least, corner.y());
      most = std::max(most, corner.y());
      const double radius = std::hypot(corner.x(), corner.z());
      EXPECT_GE(radius, 0.9 - 1e-3);
      EXPECT_LE(radius, 1.05 + 1e-9);
    }
  EXPECT_EQ(least, 0.0);
  EXPECT_EQ(most, 0.25);
}

}  // namespace
}  // namespace millwear::orchestrator
