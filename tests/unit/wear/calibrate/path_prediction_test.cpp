#include "wear/calibrate/path_prediction.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/sample_paths.h"

namespace millwear::wear {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

// dA/dt = 2 (1 + A) and dL/dt = 3 (1 + A): after t, A = e^(2 t) - 1 and L = 3/2 A.
TEST(LossAt, FollowsAGrowingPace) {
  const WearPath path = one_zone_path({{1.0, {2.0, 4.0}, {3.0, 6.0}}});
  for (const double time : {0.1, 0.2, 0.5 * std::log(2.0)}) {
    const PathLoss loss = loss_at(path, VectorXd::Ones(1), time);
    EXPECT_NEAR(loss.lost[0], 1.5 * std::expm1(2.0 * time), 1e-6);
  }
  EXPECT_NEAR(time_of_path(path, VectorXd::Ones(1)), 0.5 * std::log(2.0), 1e-12);
}

// Over two pieces of one pace, 1 m2/s, and after them by the last loss: 1 + 3 + 0.5 x 3.
TEST(LossAt, GoesOnAfterTheLastLiner) {
  const WearPath path =
      one_zone_path({{1.0, {1.0, 1.0}, {1.0, 1.0}}, {1.0, {1.0, 1.0}, {3.0, 3.0}}});
  const PathLoss loss = loss_at(path, VectorXd::Ones(1), 2.5);
  EXPECT_NEAR(loss.lost[0], 5.5, 1e-12);
}

TEST(LossAt, IsNothingForANewLiner) {
  EXPECT_EQ(loss_at(two_mechanism_path(), Vector2d(1.0, 2.0), 0.0).lost.norm(), 0.0);
}

// One number on all factors is a change of clock.
RC_GTEST_PROP(LossAt, ScalesWithTime, ()) {
  const double factor = *rc::gen::inRange(1, 1000) * 1e-2;
  const double time = *rc::gen::inRange(1, 300) * 1e-2;
  const PathLoss fast = loss_at(two_mechanism_path(), factor * Vector2d(1.0, 0.5), time / factor);
  const PathLoss slow = loss_at(two_mechanism_path(), Vector2d(1.0, 0.5), time);
  RC_ASSERT((fast.lost - slow.lost).norm() <= 1e-12 * slow.lost.norm());
}

RC_GTEST_PROP(LossAt, IsMadeOfWhatTheMechanismsTook, ()) {
  const Vector2d factors(*rc::gen::inRange(0, 100) * 1e-2, *rc::gen::inRange(1, 100) * 1e-2);
  const PathLoss loss = loss_at(two_mechanism_path(), factors, *rc::gen::inRange(1, 300) * 1e-2);
  RC_ASSERT((loss.taken * factors - loss.lost).norm() <= 1e-12);
}

RC_GTEST_PROP(LossAt, KnowsItsChangeWithTheFactors, ()) {
  const Vector2d factors(*rc::gen::inRange(10, 100) * 1e-2, *rc::gen::inRange(10, 100) * 1e-2);
  const double time = *rc::gen::inRange(10, 300) * 1e-2;
  const PathLoss loss = loss_at(two_mechanism_path(), factors, time);
  for (Eigen::Index m = 0; m < 2; ++m) {
    const double step = 1e-5;
    const VectorXd above =
        loss_at(two_mechanism_path(), factors + step * Vector2d::Unit(m), time).lost;
    const VectorXd below =
        loss_at(two_mechanism_path(), factors - step * Vector2d::Unit(m), time).lost;
    const VectorXd change = (above - below) / (2.0 * step);
    RC_ASSERT((change - loss.per_factor.col(m)).norm() <= 2e-3 * (change.norm() + 1e-3));
  }
}

// The second mechanism alone does not wear the second half of the path: the liner stays there.
TEST(LossAt, StopsWhereNothingWears) {
  WearPath path = two_mechanism_path();
  for (auto* rates : {&path.pieces.back().start, &path.pieces.back().end}) {
    rates->pace[1] = 0.0;
    rates->losses.col(1).setZero();
  }
  EXPECT_EQ(time_of_path(path, Vector2d(0.0, 1.0)), std::numeric_limits<double>::infinity());
  const PathLoss soon = loss_at(path, Vector2d(0.0, 1.0), 100.0);
  const PathLoss late = loss_at(path, Vector2d(0.0, 1.0), 1000.0);
  EXPECT_NEAR((late.lost - soon.lost).norm(), 0.0, 1e-9);
  EXPECT_TRUE(late.per_factor.allFinite());
}

}  // namespace
}  // namespace millwear::wear
