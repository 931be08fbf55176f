#include "wear/charge/bed_profile.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "wear/charge/charge_landmarks.h"

namespace millwear::wear {
namespace {

using Eigen::Vector2d;
using testing::DoubleNear;

constexpr double degree = std::numbers::pi / 180.0;
constexpr double cell = 0.005;

// A drum of radius 0.5 whose bed lies 0.1 below the axis, with its surface inclined by 27 degrees
// (up on the left, where the wall rises). Along the surface it goes at 2 (depth - 0.28) m/s.
ChargeFields bed() {
  ChargeFields fields = no_charge_fields({0.6, 240}, 0.25, 1);
  fields.instants = 2.0;
  const Vector2d down(-std::cos(297.0 * degree), std::sin(297.0 * degree));
  const Vector2d up_slope(std::sin(297.0 * degree), std::cos(297.0 * degree));
  for (Eigen::Index i = 0; i < fields.grid.count(); ++i) {
    const Vector2d place((static_cast<double>(i % 240) + 0.5) * cell - 0.6,
                         (static_cast<double>(i / 240) + 0.5) * cell - 0.6);
    if (place.norm() > 0.5 || place.dot(down) < 0.1) continue;
    const Vector2d v = 2.0 * (place.dot(down) - 0.28) * up_slope;
    fields.sums.row(i) << 1.2, 3.0, 3.0 * v.x(), 0.0, 3.0 * v.y(), 3.0 * v.squaredNorm();
  }
  return fields;
}

TEST(BedProfile, HasTheAngleAndTheFlowOfARollingBed) {
  const auto fields = bed();
  const auto ends = landmarks_of(fields, 0.48);
  const BedProfile found = bed_profile_of(fields, ends.shoulder, ends.bulk_toe, 0.5);
  EXPECT_THAT(found.surface_angle / degree, DoubleNear(27.0, 0.5));
  EXPECT_THAT(found.surface_depth, DoubleNear(0.1, cell));
  EXPECT_THAT(found.turning_depth, DoubleNear(0.28, 0.2 * cell));
  EXPECT_THAT(found.surface_speed, DoubleNear(0.36, 2.0 * cell));
  EXPECT_THAT(found.velocity.tail<30>().head<1>()[0],
              DoubleNear(2.0 * (found.depth.tail<30>().head<1>()[0] - 0.28), 0.01));
}

TEST(BedProfile, OfAnEmptyMillIsUnknown) {
  const BedProfile found = bed_profile_of(no_charge_fields({0.6, 240}, 0.25, 1), 6.0, 4.0, 0.5);
  EXPECT_TRUE(std::isnan(found.surface_speed));
  EXPECT_TRUE(std::isnan(found.turning_depth));
}

}  // namespace
}  // namespace millwear::wear
