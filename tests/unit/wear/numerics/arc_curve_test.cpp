#include "wear/numerics/arc_curve.h"

#include <gtest/gtest.h>

namespace millwear::wear {
namespace {

// Four bins of 1 m with centres at 0.5 ... 3.5 m; over the edge the last and the first meet.
const ArcCurve curve{Eigen::VectorXd::LinSpaced(5, 0.0, 4.0), Eigen::Vector4d(1.0, 2.0, 4.0, 3.0)};

TEST(ArcCurve, IsTheBinsValueAtItsCentre) { EXPECT_DOUBLE_EQ(curve.at(2.5), 4.0); }

TEST(ArcCurve, IsLinearBetweenCentres) { EXPECT_DOUBLE_EQ(curve.at(1.75), 2.5); }

// A curve of the mirror image, which is run through from its other end.
TEST(ArcCurve, OfAReversedMillIsTheSameFromTheOtherEnd) {
  const ArcCurve turned = as_turned(curve, Rotation::reversed);
  for (const double s : {0.0, 0.5, 1.75, 3.9}) EXPECT_DOUBLE_EQ(turned.at(4.0 - s), curve.at(s));
  EXPECT_EQ(as_turned(curve, Rotation::as_new).values, curve.values);
}

TEST(ArcCurve, GoesOnAcrossTheSectorEdge) {
  EXPECT_DOUBLE_EQ(curve.at(0.0), 2.0);
  EXPECT_DOUBLE_EQ(curve.at(4.0), 2.0);
  EXPECT_DOUBLE_EQ(curve.at(-1.5), curve.at(2.5));
  EXPECT_DOUBLE_EQ(curve.at(9.75), curve.at(1.75));
}

}  // namespace
}  // namespace millwear::wear
