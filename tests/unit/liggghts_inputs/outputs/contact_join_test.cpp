#include "liggghts_inputs/outputs/contact_join.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <cmath>

#include "mill/base/failure.h"
#include "tests/support/example_case.h"

namespace millwear::liggghts {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr StretchSteps steps{1e-3, 100, 100, 20};
constexpr double slice = 0.2;
constexpr double radius = 0.025;  ///< of the first class of example_case, steel

/// A sphere of the first class that touches the plate at six o'clock.
struct Touch {
  double id = 7;
  double type = 1;
  double size = radius;
  Eigen::Vector3d centre{0.0, 0.1, -0.5 + radius};
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();
  Eigen::Vector3d point{0.0, 0.1, -0.5};
  Eigen::Vector3d force{0.0, 0.0, 12.0};
  Eigen::Vector3d tangential_force{100.0, 0.0, 0.0};
};

Snapshot contacts_of(long step, const std::vector<Touch>& touches) {
  Snapshot snapshot{step, contact_columns, {}};
  for (const auto& t : touches)
    snapshot.values.insert(
        snapshot.values.end(),
        {t.point.x(), t.point.y(), t.point.z(), 5.0, t.id, t.force.x(), t.force.y(), t.force.z(),
         t.tangential_force.x(), t.tangential_force.y(), t.tangential_force.z()});
  return snapshot;
}

Snapshot spins_of(long step, const std::vector<Touch>& touches) {
  Snapshot snapshot{step, spin_columns, {}};
  for (const auto& t : touches)
    snapshot.values.insert(
        snapshot.values.end(),
        {t.id, t.type, t.size, t.centre.x(), t.centre.y(), t.centre.z(), t.velocity.x(),
         t.velocity.y(), t.velocity.z(), t.spin.x(), t.spin.y(), t.spin.z()});
  return snapshot;
}

Case mill_at(double speed) {
  Case mill = example_case();
  mill.speed = speed;
  return mill;
}

WallContacts joined(const Case& mill, const std::vector<Touch>& touches, long step = 120) {
  WallContacts sample{};
  ContactJoin join(mill, steps, [&](const WallContacts& s) { sample = s; });
  join.take_contacts(contacts_of(step, touches));
  join.take_spins(spins_of(step, touches));
  return sample;
}

WallContact joined(const Touch& touch, double speed = 0.0) {
  return joined(mill_at(speed), {touch}).contacts.at(0);
}

// Friction gives up to mu 12 N here; with less the contact holds, and its spring takes half a slip
// and gives it back.
TEST(ContactJoin, AContactThatHoldsCountsTheSwingOfItsSpring) {
  Touch touch;
  touch.velocity = {1.0, 0.0, 0.0};
  const double most =
      pair_of(example_case(), 0, example_case().liner_material).sliding_friction * 12.0;
  touch.tangential_force = {-1.001 * most, 0.0, 0.0};
  EXPECT_NEAR(joined(touch).slip_speed, 1.0, 1e-12);
  EXPECT_NEAR(joined(touch).shear_power, most, 1e-12);
  touch.tangential_force = {-0.5 * most, 0.0, 0.0};
  EXPECT_NEAR(joined(touch).slip_speed, 0.5, 1e-12);
  EXPECT_NEAR(joined(touch).shear_power, 0.5 * most, 1e-12);
  touch.tangential_force = {0.5 * most, 0.0, 0.0};
  EXPECT_NEAR(joined(touch).slip_speed, -0.5, 1e-12);
}

TEST(ContactJoin, GivesTheSampleItsTimeAndTheMillItsAngle) {
  const auto sample = joined(mill_at(3.0), {Touch{}}, 140);
  EXPECT_DOUBLE_EQ(sample.time, 0.040);
  EXPECT_DOUBLE_EQ(sample.mill_angle, 3.0 * 0.140);
  const auto& contact = sample.contacts.at(0);
  EXPECT_EQ(contact.point, Eigen::Vector3d(0.0, 0.1, -0.5));
  EXPECT_DOUBLE_EQ(contact.normal_force, 12.0);
  EXPECT_EQ(contact.particle_class, 0u);
  EXPECT_EQ(contact.triangle, 5u);
}

// At rest but for 40 rad/s: the surface moves with omega r = 40 x 0.025 = 1 m/s.
TEST(ContactJoin, SpinningSphereSlipsBySpinTimesRadius) {
  Touch touch;
  touch.spin = {0.0, 40.0, 0.0};
  EXPECT_NEAR(joined(touch).slip_speed, 1.0, 1e-12);
  touch.spin = {0.0, 0.0, 40.0};
  EXPECT_NEAR(joined(touch).slip_speed, 0.0, 1e-12) << "spin about the normal";
}

// To +x with 1 m/s over the floor: rolling turns about +y by v / r.
TEST(ContactJoin, RollingSphereDoesNotSlip) {
  Touch touch;
  touch.velocity = {1.0, 0.0, 0.0};
  touch.tangential_force = {-100.0, 0.0, 0.0};
  EXPECT_NEAR(joined(touch).slip_speed, 1.0, 1e-12);
  touch.spin = {0.0, 1.0 / radius, 0.0};
  EXPECT_NEAR(joined(touch).slip_speed, 0.0, 1e-12);
}

// The mill turns about +y, so its floor moves to -x with 3 x 0.5 = 1.5 m/s.
TEST(ContactJoin, SphereCarriedByTheTurningWallDoesNotSlip) {
  Touch touch;
  touch.tangential_force = {-100.0, 0.0, 0.0};
  EXPECT_NEAR(joined(touch, 3.0).slip_speed, 1.5, 1e-12);
  touch.velocity = {-1.5, 0.0, 0.0};
  EXPECT_NEAR(joined(touch, 3.0).slip_speed, 0.0, 1e-12);
}

TEST(ContactJoin, ClosingSpeedIsPositiveOnApproachAndNoSlip) {
  Touch touch;
  touch.velocity = {0.3, 0.4, -2.0};
  touch.tangential_force = {-60.0, -80.0, 0.0};
  EXPECT_NEAR(joined(touch).normal_speed, 2.0, 1e-12);
  EXPECT_NEAR(joined(touch).slip_speed, 0.5, 1e-12);
  touch.force = {0.0, 0.0, -1.0};
  EXPECT_NEAR(joined(touch).normal_force, -1.0, 1e-12) << "damping pulls";
}

// A sphere at y = 0.001 may be reported to touch at y = 0.2 - 0.001, and the other way round.
TEST(ContactJoin, ArmReachesAcrossThePeriodicEdge) {
  for (const double y : {0.001, slice - 0.001}) {
    Touch touch;
    touch.centre.y() = y;
    touch.point.y() = slice - y;
    touch.spin = {40.0, 0.0, 0.0};
    touch.tangential_force = {0.0, -100.0, 0.0};
    Touch inside = touch;
    inside.centre.y() = 0.1;
    inside.point.y() = 0.1 + (y < 0.1 ? -0.002 : 0.002);
    EXPECT_NEAR(joined(touch).slip_speed, joined(inside).slip_speed, 1e-12);
    EXPECT_NEAR(joined(touch).normal_force, joined(inside).normal_force, 1e-12);
    EXPECT_NEAR(joined(touch).normal_force, 12.0, 0.1);
  }
}

TEST(ContactJoin, FindsTheClassByMaterialAndSize) {
  Touch ore;
  ore.type = 2;
  ore.size = 0.010;
  ore.centre.z() = -0.5 + ore.size;
  EXPECT_EQ(joined(ore).particle_class, 2u);
  ore.size = 0.011;
  EXPECT_THAT([&] { joined(ore); }, ThrowsMessage<ResultRejected>(HasSubstr("radius 0.011")));
  Touch small_steel;
  small_steel.size = 0.010;
  EXPECT_THAT([&] { joined(small_steel); }, ThrowsMessage<ResultRejected>(HasSubstr("no class")));
}

TEST(ContactJoin, RefusesAContactOfAParticleWithoutSpin) {
  ContactJoin join(mill_at(0.0), steps, [](const WallContacts&) {});
  Touch other;
  other.id = 8;
  join.take_spins(spins_of(120, {other}));
  EXPECT_THAT([&] { join.take_contacts(contacts_of(120, {Touch{}})); },
              ThrowsMessage<ResultRejected>(HasSubstr("particle 7 touches the wall at step 120")));
}

TEST(ContactJoin, RefusesParticlesTheChargeDoesNotHave) {
  for (const double id : {5000.0, -1.0, 0.0, 1e300}) {
    Touch touch;
    touch.id = id;
    EXPECT_THROW(static_cast<void>(joined(touch)), ResultRejected) << id;
  }
}

TEST(ContactJoin, DoesNotTakeTheSpinOfAnEarlierStep) {
  ContactJoin join(mill_at(0.0), steps, [](const WallContacts&) {});
  join.take_contacts(contacts_of(120, {Touch{}}));
  join.take_spins(spins_of(120, {Touch{}}));
  join.take_contacts(contacts_of(140, {Touch{}}));
  EXPECT_THROW(join.take_spins(spins_of(140, {})), ResultRejected);
}

TEST(ContactJoin, RefusesDumpsOfDifferentSteps) {
  ContactJoin join(mill_at(0.0), steps, [](const WallContacts&) {});
  join.take_contacts(contacts_of(120, {Touch{}}));
  EXPECT_THAT([&] { join.take_spins(spins_of(140, {Touch{}})); },
              ThrowsMessage<ResultRejected>(HasSubstr("do not hold the same steps (step 120)")));
}

TEST(ContactJoin, WantsEverySampleFromBothDumpsInAnyOrder) {
  int samples = 0;
  ContactJoin join(mill_at(0.0), steps, [&](const WallContacts&) { ++samples; });
  for (const long step : {100, 120, 140, 160, 180, 200})
    join.take_contacts(contacts_of(step, {Touch{}}));
  EXPECT_THROW(join.finish(), ResultRejected);
  for (const long step : {100, 120, 140, 160, 180}) join.take_spins(spins_of(step, {Touch{}}));
  EXPECT_THROW(join.finish(), ResultRejected);
  join.take_spins(spins_of(200, {Touch{}}));
  join.finish();
  EXPECT_EQ(samples, 5) << "the sample at the very start does not count";
  EXPECT_EQ(join.last_step(), 200);
}

// Settling ends with step 30, then come 50 steps with a sample every 20: as the dumps hold them, at
// 30 to begin with, at 50, 70 and, as the measurement ends, at 80, which stands for 10 steps.
TEST(ContactJoin, EverySampleStandsForTheTimeSinceTheOneBefore) {
  std::vector<double> times, intervals;
  int beginnings = 0;
  ContactJoin join(
      mill_at(0.0), StretchSteps{1e-3, 30, 50, 20},
      [&](const WallContacts& sample) {
        times.push_back(sample.time);
        intervals.push_back(sample.interval.value());
      },
      [&](const WallContacts&) { ++beginnings; });
  for (const long step : {30, 50, 70, 80}) {
    join.take_contacts(contacts_of(step, {Touch{}}));
    join.take_spins(spins_of(step, {Touch{}}));
  }
  join.finish();
  EXPECT_EQ(beginnings, 1);
  EXPECT_THAT(times, ElementsAre(DoubleEq(0.02), DoubleEq(0.04), DoubleEq(0.05)));
  EXPECT_THAT(intervals, ElementsAre(DoubleEq(0.02), DoubleEq(0.02), DoubleEq(0.01)));
}

TEST(ContactJoin, WantsTheStepWithWhichTheMeasurementBegins) {
  ContactJoin join(mill_at(0.0), steps, [](const WallContacts&) {});
  for (const long step : {120, 140, 160, 180, 200}) {
    join.take_contacts(contacts_of(step, {Touch{}}));
    join.take_spins(spins_of(step, {Touch{}}));
  }
  EXPECT_THAT([&] { join.finish(); }, ThrowsMessage<ResultRejected>(HasSubstr("step 100")));
}

// A mill about -x with gravity along +y: its axis is our y, upwards our z.
TEST(ContactJoin, TurnsTheAxesOfTheDeckToTheMills) {
  DumpFrame frame = dump_frame(steps);
  frame.to_mill << 0.0, 0.0, -1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
  frame.angle = 0.25;
  frame.angle_step = 20;
  const Case mill = mill_at(3.0);
  WallContacts sample{};
  ContactJoin join(mill, 10, frame, [&](const WallContacts& s) { sample = s; });
  Touch touch;
  const Eigen::Matrix3d from_mill = frame.to_mill.transpose();
  for (Eigen::Vector3d* const vector : {&touch.centre, &touch.velocity, &touch.spin, &touch.point,
                                        &touch.force, &touch.tangential_force})
    *vector = from_mill * *vector;
  join.take_contacts(contacts_of(120, {touch}));
  join.take_spins(spins_of(120, {touch}));
  const WallContact expected = joined(Touch{}, 3.0);
  const WallContact& found = sample.contacts.at(0);
  EXPECT_NEAR((found.point - expected.point).norm(), 0.0, 1e-15);
  EXPECT_NEAR(found.normal_force, expected.normal_force, 1e-12);
  EXPECT_NEAR(found.slip_speed, expected.slip_speed, 1e-12);
  EXPECT_DOUBLE_EQ(sample.mill_angle, 0.25 + 3.0 * 0.100);
}

// The dumps of another run have the particle elsewhere at the same step.
TEST(ContactJoin, RefusesAContactThatIsNotOnItsParticle) {
  ContactJoin join(mill_at(0.0), steps, [](const WallContacts&) {});
  Touch elsewhere;
  elsewhere.centre.x() = 0.2;
  join.take_contacts(contacts_of(120, {Touch{}}));
  EXPECT_THAT([&] { join.take_spins(spins_of(120, {elsewhere})); },
              ThrowsMessage<ResultRejected>(HasSubstr("not of one run")));
}

TEST(ContactJoin, WantsAsManySamplesAsTheStretchHas) {
  ContactJoin join(mill_at(0.0), steps, [](const WallContacts&) {});
  for (const long step : {100, 120, 140, 160, 180}) {
    join.take_contacts(contacts_of(step, {Touch{}}));
    join.take_spins(spins_of(step, {Touch{}}));
  }
  EXPECT_THAT([&] { join.finish(); },
              ThrowsMessage<ResultRejected>(HasSubstr("4 samples of the wall contacts, up to step "
                                                      "180, and not 5, up to step 200")));
}

TEST(ContactJoin, HoldsNoSnapshotThatIsJoined) {
  ContactJoin join(mill_at(0.0), steps, [](const WallContacts&) {});
  const std::vector<Touch> touches(50);
  const auto feed = [&](long from, long to) {
    for (long step = from; step < to; ++step) {
      join.take_contacts(contacts_of(step, touches));
      join.take_spins(spins_of(step, touches));
    }
  };
  feed(101, 111);
  const auto first_heap = mallinfo2().uordblks;
  feed(111, 10111);
  EXPECT_LE(mallinfo2().uordblks, first_heap + 4096);
}

}  // namespace
}  // namespace millwear::liggghts
