#include "mill/load/contact_motion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace millwear {
namespace {

using Eigen::Vector3d;

const Vector3d down{0.0, 0.0, -1.0};

// A ball of 0.05 m that rolls along x at 1 m/s on a floor turns with 20 1/s about y, and the place
// where it touches stands still.
TEST(ContactMotion, ARollingBallDoesNotSlip) {
  const auto motion = contact_motion(0.05 * down, 0.05, {1.0, 0.0, 0.0}, {0.0, 20.0, 0.0});
  EXPECT_NEAR(motion.slip.norm(), 0.0, 1e-15);
  EXPECT_EQ(motion.normal_speed, 0.0);
  EXPECT_EQ(motion.impact_speed, 1.0);
  EXPECT_EQ(motion.into_wall, down);
}

// Spinning on the spot with 20 1/s about y, its foot slips with 1 m/s against x.
TEST(ContactMotion, ASpinningBallSlipsWithoutMoving) {
  const auto motion = contact_motion(0.05 * down, 0.05, Vector3d::Zero(), {0.0, 20.0, 0.0});
  EXPECT_NEAR((motion.slip - Vector3d(-1.0, 0.0, 0.0)).norm(), 0.0, 1e-15);
  EXPECT_EQ(motion.impact_speed, 0.0);
}

TEST(ContactMotion, SpinAboutTheNormalSlipsNowhere) {
  const auto motion = contact_motion(0.05 * down, 0.05, Vector3d::Zero(), {0.0, 0.0, 300.0});
  EXPECT_EQ(motion.slip.norm(), 0.0);
}

// 3 m/s along, 4 m/s into the floor: 5 m/s; it closes with 4 m/s and slips with 3 m/s.
TEST(ContactMotion, SplitsTheVelocityAlongAndIntoTheWall) {
  const auto motion = contact_motion(0.05 * down, 0.05, {3.0, 0.0, -4.0}, Vector3d::Zero());
  EXPECT_DOUBLE_EQ(motion.normal_speed, 4.0);
  EXPECT_EQ(motion.slip, Vector3d(3.0, 0.0, 0.0));
  EXPECT_DOUBLE_EQ(motion.impact_speed, 5.0);
  EXPECT_DOUBLE_EQ(
      contact_motion(0.05 * down, 0.05, {3.0, 0.0, 4.0}, Vector3d::Zero()).normal_speed, -4.0);
}

TEST(ContactMotion, SlipLiesInTheWall) {
  const Vector3d arm(0.01, -0.02, 0.03);
  const auto motion = contact_motion(arm, arm.norm(), {1.0, 2.0, 3.0}, {40.0, -50.0, 60.0});
  EXPECT_NEAR(motion.slip.dot(arm), 0.0, 1e-15);
}

double power_at(double angle, double speed = 2.0, double force = 100.0) {
  const Vector3d velocity = speed * Vector3d(std::cos(angle), 0.0, -std::sin(angle));
  return finnie_power(velocity, 0.05 * down, -down, force);
}

// 2 f |v| F: at atan(1/4) sin(2a) = 8/17 and sin(a)^2 = 1/17, f = 5/17; at atan(2/5) cos(a)^2 =
// 25/29, f = 25/87; at atan(1) f = 1/6; at 60 degrees f = 1/12.
TEST(Finnie, MatchesItsClosedForm) {
  EXPECT_NEAR(power_at(std::atan(0.25)), 2.0 * 5.0 / 17.0 * 2.0 * 100.0, 1e-12);
  EXPECT_NEAR(power_at(std::atan(0.4)), 2.0 * 25.0 / 87.0 * 2.0 * 100.0, 1e-12);
  EXPECT_NEAR(power_at(std::atan(1.0)), 2.0 / 6.0 * 2.0 * 100.0, 1e-12);
  EXPECT_NEAR(power_at(std::numbers::pi / 3.0), 2.0 / 12.0 * 2.0 * 100.0, 1e-12);
}

TEST(Finnie, IsNothingAlongTheWallAndStraightIntoIt) {
  EXPECT_EQ(power_at(0.0), 0.0);
  EXPECT_NEAR(power_at(0.5 * std::numbers::pi), 0.0, 1e-12);
}

// Both branches give f = 0.3 at tan(a) = 1/3.
TEST(Finnie, IsContinuousWhereItsBranchesMeet) {
  const double meet = std::atan(1.0 / 3.0);
  EXPECT_NEAR(power_at(meet), 2.0 * 0.3 * 2.0 * 100.0, 1e-9);
  EXPECT_NEAR(power_at(meet * (1.0 - 1e-12)), power_at(meet * (1.0 + 1e-12)), 1e-9);
}

TEST(Finnie, GrowsWithSpeedAndForce) {
  EXPECT_NEAR(power_at(0.7, 4.0, 300.0), 6.0 * power_at(0.7, 2.0, 100.0), 1e-12);
}

TEST(Finnie, IsNothingWhileTheBallLeavesOrStands) {
  EXPECT_EQ(power_at(-0.3), 0.0);
  EXPECT_EQ(power_at(0.3, 0.0), 0.0);
  EXPECT_EQ(power_at(0.3, 1e-8), 0.0);
}

TEST(Finnie, TakesTheWallsNormalEitherWay) {
  const Vector3d velocity(1.0, 0.0, -1.0);
  EXPECT_EQ(finnie_power(velocity, 0.05 * down, down, 10.0),
            finnie_power(velocity, 0.05 * down, -down, 10.0));
}

/// `sliding_speed` of a contact with this slip, and a damper of so many N s/m while it holds.
double sliding(const Vector3d& slip, const Vector3d& tangential_force, double normal_force,
               double friction, double damping) {
  const ContactMotion motion{down, 0.0, slip, slip.norm(), 1.0};
  return sliding_speed(motion, tangential_force, normal_force, {friction, damping});
}

TEST(ContactMotion, OverlapsByWhatTheArmIsShorterThanTheRadius) {
  EXPECT_DOUBLE_EQ(contact_motion(0.049 * down, 0.05, Vector3d::Zero(), Vector3d::Zero()).overlap,
                   0.001);
}

// mu Fn = 3 N is all that friction gives. LIGGGHTS takes |Fn| also while damping pulls.
TEST(ContactMotion, SlidesWhereFrictionGivesAllItCan) {
  const Vector3d slip{2.0, 0.0, 0.0};
  const auto against = [](double force) { return Vector3d{-force, 0.0, 0.0}; };
  EXPECT_EQ(sliding(slip, against(3.0), 10.0, 0.3, 7.0), 2.0);
  EXPECT_EQ(sliding(slip, against(3.0 * (1.0 - 1e-9)), 10.0, 0.3, 7.0), 2.0) << "rounding";
  EXPECT_EQ(sliding(slip, against(3.0), -10.0, 0.3, 7.0), 2.0);
  EXPECT_EQ(sliding(slip, against(0.0), 0.0, 0.3, 7.0), 0.0);
  EXPECT_EQ(sliding(slip, against(0.0), 10.0, 0.0, 7.0), 2.0) << "without friction";
}

// Half of what friction can do is spent, and the damper takes 0.1 N s/m (2 m/s)^2 of the power.
TEST(ContactMotion, HeldByFrictionCountsWhatItsSpringTakes) {
  const double force = 1.5;
  EXPECT_DOUBLE_EQ(sliding({2.0, 0.0, 0.0}, {-force, 0.0, 0.0}, 10.0, 0.3, 0.1),
                   (2.0 * force - 0.1 * 4.0) / 3.0);
}

// At the limit, what moves across the force is the spring alone, and with it it comes back.
TEST(ContactMotion, SlidesAgainstTheForceOnly) {
  EXPECT_NEAR(sliding({3.0, 4.0, 0.0}, {-3.0, 0.0, 0.0}, 10.0, 0.3, 7.0), 3.0, 1e-15);
  EXPECT_EQ(sliding({0.0, 4.0, 0.0}, {-3.0, 0.0, 0.0}, 10.0, 0.3, 7.0), 0.0);
  EXPECT_EQ(sliding({-3.0, 0.0, 0.0}, {-3.0, 0.0, 0.0}, 10.0, 0.3, 7.0), -3.0);
}

TEST(ContactMotion, PathIsAllSlipAtTheLimitAndNoneOfAHeldContact) {
  const ContactMotion motion{down, 0.0, {3.0, 4.0, 0.0}, 5.0, 1.0};
  const LinerFriction friction{0.3, 7.0};
  EXPECT_EQ(path_speed(motion, {-3.0, 0.0, 0.0}, 10.0, friction), 5.0);
  EXPECT_EQ(path_speed(motion, {0.0, 3.0, 0.0}, -10.0, friction), 5.0);
  EXPECT_EQ(path_speed(motion, {-2.9, 0.0, 0.0}, 10.0, friction), 0.0);
  EXPECT_EQ(path_speed(motion, Vector3d::Zero(), 10.0, {0.0, 7.0}), 5.0) << "without friction";
}

/// A spring that friction cuts, and a damper while it holds, in the steps of a DEM.
class SpringAndSlider {
 public:
  /// Takes a step at a speed; the sums of `sliding_speed` and `path_speed` over time grow.
  void move(double speed) {
    spring_ += speed * dt;
    const double cut = std::clamp(spring_, -longest, longest);
    slid_ += std::abs(spring_ - cut);
    const bool held = cut == spring_;
    spring_ = cut;
    const double force = stiffness * spring_ + (held ? damping * speed : 0.0);
    const ContactMotion motion{down, 0.0, {speed, 0.0, 0.0}, std::abs(speed), 1.0};
    const LinerFriction resists{friction, damping};
    counted_ += dt * sliding_speed(motion, {-force, 0.0, 0.0}, load, resists);
    path_ += dt * path_speed(motion, {-force, 0.0, 0.0}, load, resists);
  }
  [[nodiscard]] double slid() const { return slid_; }
  [[nodiscard]] double counted() const { return counted_; }
  [[nodiscard]] double path() const { return path_; }

  static constexpr double dt = 1e-4, stiffness = 1e5, damping = 5.0, load = 100.0, friction = 0.5;
  static constexpr double longest = friction * load / stiffness;  ///< that the spring can be [m]

 private:
  double spring_ = 0.0;
  double slid_ = 0.0;
  double counted_ = 0.0;
  double path_ = 0.0;
};

// Slid by 50 times what the spring can be: the spring keeps half of its last stretch.
TEST(ContactMotion, CountsTheSlipOfASpringThatFrictionCuts) {
  SpringAndSlider contact;
  for (int step = 0; step < 2500; ++step) contact.move(0.1);
  EXPECT_NEAR(contact.slid(), 49.0 * SpringAndSlider::longest, 1e-9);
  EXPECT_NEAR(contact.counted(), contact.slid() + 0.5 * SpringAndSlider::longest,
              0.02 * SpringAndSlider::longest);
  EXPECT_NEAR(contact.path(), contact.slid(), 0.02 * contact.slid());
}

// A jammed particle that shakes in every step, a hundredth of what the spring can be: it comes to
// the limit and slides by as much as it drifts, not by the path it shakes, 39 times as long.
TEST(ContactMotion, CountsTheDriftOfAParticleThatShakesAndNotItsPath) {
  SpringAndSlider contact;
  const double shake = 0.01 * SpringAndSlider::longest / SpringAndSlider::dt;
  double path = 0.0;
  for (int step = 0; step < 40000; ++step) {
    const double speed = step % 2 == 0 ? 1.05 * shake : -shake;
    contact.move(speed);
    path += std::abs(speed) * SpringAndSlider::dt;
  }
  EXPECT_GT(path, 39.0 * contact.slid());
  EXPECT_NEAR(contact.counted(), contact.slid(), 0.3 * contact.slid());
  EXPECT_GT(contact.path(), 15.0 * contact.slid());
}

}  // namespace
}  // namespace millwear
