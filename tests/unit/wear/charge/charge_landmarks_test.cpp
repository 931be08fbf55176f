#include "wear/charge/charge_landmarks.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

namespace millwear::wear {
namespace {

using Eigen::Vector2d;
using testing::DoubleNear;

const SectionGrid grid{1.0, 100};
constexpr double cell = 0.02;

double angle_from_six(const Vector2d& place) { return std::atan2(-place.x(), -place.y()); }

/// One instant, every cell of `where` filled by 0.6 and of mass 1, moving with `velocity`.
ChargeFields fields_of(const std::function<bool(const Vector2d&)>& where,
                       const std::function<Vector2d(const Vector2d&)>& velocity) {
  ChargeFields fields = no_charge_fields(grid, 0.25, 1);
  fields.instants = 1.0;
  for (Eigen::Index i = 0; i < grid.count(); ++i) {
    const Vector2d place((static_cast<double>(i % 100) + 0.5) * cell - 1.0,
                         (static_cast<double>(i / 100) + 0.5) * cell - 1.0);
    if (!where(place)) continue;
    const Vector2d v = velocity(place);
    fields.sums.row(i) << 0.6, 1.0, v.x(), 0.0, v.y(), v.squaredNorm();
  }
  return fields;
}

const auto at_rest = [](const Vector2d&) { return Vector2d(0.0, 0.0); };

// A disc that turns about (-0.31, -0.43) as a whole, up on its left side.
TEST(ChargeLandmarks, TheCentreOfCirculationIsWhatTheChargeTurnsAbout) {
  const Vector2d centre(-0.31, -0.43);
  const auto fields = fields_of([&](const Vector2d& p) { return (p - centre).norm() < 0.4; },
                                [&](const Vector2d& p) {
                                  const Vector2d arm = p - centre;
                                  return Vector2d(2.0 * arm.y(), -2.0 * arm.x());
                                });
  const ChargeLandmarks found = landmarks_of(fields, 0.9);
  EXPECT_THAT(found.centre.x(), DoubleNear(centre.x(), 0.5 * cell));
  EXPECT_THAT(found.centre.y(), DoubleNear(centre.y(), 0.5 * cell));
  EXPECT_THAT(found.head.y(), DoubleNear(centre.y() + 0.4, cell));
}

// From 35 degrees before six o'clock to 125 after it: 235 and 35 degrees from three o'clock.
TEST(ChargeLandmarks, BulkToeAndShoulderAreTheEndsOfTheChargeAlongTheLifters) {
  const auto fields = fields_of(
      [](const Vector2d& p) {
        const double degrees = angle_from_six(p) * 180.0 / M_PI;
        return p.norm() > 0.5 && p.norm() < 0.95 && degrees > -35.0 && degrees < 125.0;
      },
      at_rest);
  const ChargeLandmarks found = landmarks_of(fields, 0.8);
  EXPECT_THAT(found.bulk_toe * 180.0 / M_PI, DoubleNear(235.0, 1.0));
  EXPECT_THAT(found.shoulder * 180.0 / M_PI, DoubleNear(35.0, 1.0));
}

TEST(ChargeLandmarks, AChargeAllTheWayAroundHasNeitherToeNorShoulder) {
  const ChargeLandmarks found =
      landmarks_of(fields_of([](const Vector2d& p) { return p.norm() > 0.7; }, at_rest), 0.9);
  EXPECT_TRUE(std::isnan(found.bulk_toe));
  EXPECT_TRUE(std::isnan(found.shoulder));
  EXPECT_TRUE(std::isnan(found.centre.x()));
}

TEST(ChargeLandmarks, NoChargeHasNone) {
  const ChargeLandmarks found = landmarks_of(no_charge_fields(grid, 0.25, 1), 0.9);
  EXPECT_TRUE(std::isnan(found.head.x()));
  EXPECT_TRUE(std::isnan(found.shoulder));
}

}  // namespace
}  // namespace millwear::wear
