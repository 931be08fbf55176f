#include "orchestrator/postprocess/deck_axes.h"

#include <gmock/gmock.h>

#include <Eigen/LU>

#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(DeckAxes, OfADeckLikeOursStay) {
  EXPECT_EQ(axes_to_mill("+y", "-z"), Eigen::Matrix3d::Identity());
  EXPECT_EQ(axes_to_mill("y", "-z"), Eigen::Matrix3d::Identity());
}

// A mill that turns about -y, seen from its other end, turns about +y: x and y change their signs.
TEST(DeckAxes, TurnAMillThatTurnsTheOtherWayAround) {
  EXPECT_EQ(axes_to_mill("-y", "-z"), Eigen::Matrix3d(Vector3d(-1.0, -1.0, 1.0).asDiagonal()));
}

TEST(DeckAxes, AreTurnedAndNotMirrored) {
  for (const char* const axis : {"+x", "-x", "+z", "-z"}) {
    const auto turned = axes_to_mill(axis, "-y");
    EXPECT_DOUBLE_EQ(turned.determinant(), 1.0) << axis;
    EXPECT_EQ(turned * Vector3d(0.0, -1.0, 0.0), Vector3d(0.0, 0.0, -1.0)) << "gravity";
  }
}

TEST(DeckAxes, RefuseWhatIsNoAxisOrNotLevel) {
  EXPECT_THAT([] { static_cast<void>(axes_to_mill("north", "-z")); },
              ThrowsMessage<InputError>(HasSubstr("\"north\" is no axis")));
  EXPECT_THAT([] { static_cast<void>(axes_to_mill("", "-z")); },
              ThrowsMessage<InputError>(HasSubstr("is no axis")));
  EXPECT_THAT([] { static_cast<void>(axes_to_mill("+z", "-z")); },
              ThrowsMessage<InputError>(HasSubstr("level")));
}

}  // namespace
}  // namespace millwear::orchestrator
