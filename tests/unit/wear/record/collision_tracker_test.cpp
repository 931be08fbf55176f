#include "wear/record/collision_tracker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

#include "mill/base/failure.h"

namespace millwear::wear {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double dt = 0.01;
constexpr auto measured = CollisionTracker::SampleKind::measured;
constexpr auto before = CollisionTracker::SampleKind::before;

/// A contact straight below a ball, turned about y by `angle` [rad]: 0 is the plate, 90 degrees an
/// upright face. It presses with 100 N, closes with 0.2 m/s, slips with 0.5 m/s, sheds 15 W.
WallContact touch(std::size_t particle, double angle, std::size_t triangle = 0) {
  return {.point = {0.0, 0.125, 0.0},
          .into_wall = {std::sin(angle), 0.0, -std::cos(angle)},
          .normal_force = 100.0,
          .slip_speed = 0.5,
          .path_speed = 0.75,
          .normal_speed = 0.2,
          .impact_speed = 2.0,
          .impact_normal_speed = 1.0,
          .shear_power = 15.0,
          .finnie_power = 0.0,
          .particle_class = 1,
          .particle = particle,
          .triangle = triangle};
}

/// A tracker of ten particles, the number of the sample so far, and what has ended.
struct Trial {
  std::vector<Collision> ended;
  CollisionTracker tracker{10, dt, [this](const Collision& c) { ended.push_back(c); }};
  int sample = 0;

  std::size_t add(const std::vector<WallContact>& contacts,
                  CollisionTracker::SampleKind kind = measured) {
    const std::vector<LinerPlace> places(contacts.size(), LinerPlace{0.25, 3});
    const auto& begins = tracker.add(dt * sample++, kind, contacts, places);
    return static_cast<std::size_t>(std::count(begins.begin(), begins.end(), true));
  }
};

// 100 N * 0.5 m/s: 0.5 J in the tracker's own 10 ms, 0.2 J in a sample that stands for 4 ms.
TEST(CollisionTracker, TakesTheTimeThatASampleStandsFor) {
  Trial trial;
  const std::vector<WallContact> contacts = {touch(7, 0.0)};
  const std::vector<LinerPlace> places = {LinerPlace{0.25, 3}};
  trial.tracker.add(0.01, measured, contacts, places);
  trial.tracker.add(0.014, measured, contacts, places, 0.004);
  trial.tracker.finish();
  EXPECT_DOUBLE_EQ(trial.ended.at(0).sliding_work, 0.5 + 0.2);
  EXPECT_DOUBLE_EQ(trial.ended.at(0).slip_distance, 0.5 * 0.014);
}

// Three samples from t = 0: ends at 0.02 s. Work in each: 100 N * 0.5 m/s * 0.01 s = 0.5 J.
TEST(CollisionTracker, SumsOneCollisionFromItsFirstSampleToItsLast) {
  Trial trial;
  for (int i = 0; i < 3; ++i) trial.add({touch(7, 0.0)});
  trial.add({});
  ASSERT_EQ(trial.ended.size(), 1U);
  const Collision& found = trial.ended.front();
  EXPECT_EQ(found.start, 0.0);
  EXPECT_DOUBLE_EQ(found.end, 0.02);
  EXPECT_EQ(found.arc_length, 0.25);
  EXPECT_EQ(found.axial_place, 0.125);
  EXPECT_EQ(found.row, 3);
  EXPECT_EQ(found.particle, 7U);
  EXPECT_EQ(found.particle_class, 1U);
  EXPECT_EQ(found.impact_speed, 2.0);
  EXPECT_DOUBLE_EQ(found.impact_angle, 30.0 * degree);
  EXPECT_EQ(found.largest_normal_force, 100.0);
  EXPECT_DOUBLE_EQ(found.normal_dissipation, 3 * 100.0 * 0.2 * dt);
  EXPECT_DOUBLE_EQ(found.sliding_work, 3 * 0.5);
  EXPECT_DOUBLE_EQ(found.shear_dissipation, 3 * 15.0 * dt);
  EXPECT_DOUBLE_EQ(found.slip_distance, 3 * 0.5 * dt);
  EXPECT_EQ(found.unfinished, Unfinished::none);
  EXPECT_EQ(trial.tracker.open_count(), 0U);
}

// Around a corner of 120 degrees by 20 degrees a sample, a new triangle each.
TEST(CollisionTracker, ABallThatRollsOverTrianglesIsOneCollision) {
  Trial trial;
  std::size_t begun = 0;
  for (int i = 0; i <= 6; ++i)
    begun += trial.add({touch(1, 20.0 * degree * i, static_cast<std::size_t>(i))});
  EXPECT_EQ(begun, 1U);
  EXPECT_EQ(trial.tracker.open_count(), 1U);
}

TEST(CollisionTracker, PlateAndFaceOfAFootAreTwo) {
  Trial trial;
  EXPECT_EQ(trial.add({touch(1, 0.0, 4), touch(1, 80.0 * degree, 5)}), 2U);
  EXPECT_EQ(trial.add({touch(1, 0.0, 4), touch(1, 80.0 * degree, 5)}), 0U);
  trial.add({touch(1, 0.0, 4)});
  ASSERT_EQ(trial.ended.size(), 1U);
  EXPECT_DOUBLE_EQ(trial.ended.front().end, dt);
  EXPECT_EQ(trial.tracker.open_count(), 1U);
}

TEST(CollisionTracker, ThirtyDegreesAreOneSide) {
  Trial trial;
  EXPECT_EQ(trial.add({touch(1, 0.0, 0), touch(1, 29.9 * degree, 1)}), 1U);
  EXPECT_EQ(trial.add({touch(2, 0.0, 0), touch(2, 30.1 * degree, 1)}), 2U);
}

TEST(CollisionTracker, OtherParticlesAreOtherCollisions) {
  Trial trial;
  EXPECT_EQ(trial.add({touch(1, 0.0), touch(2, 0.0), touch(10, 0.0)}), 3U);
}

TEST(CollisionTracker, OneMissedSampleEndsIt) {
  Trial trial;
  EXPECT_EQ(trial.add({touch(1, 0.0)}), 1U);
  EXPECT_EQ(trial.add({}), 0U);
  EXPECT_EQ(trial.add({touch(1, 0.0)}), 1U);
  EXPECT_EQ(trial.ended.size(), 1U);
}

TEST(CollisionTracker, FlagsWhatTouchedBeforeAndWhatStillDoes) {
  Trial trial;
  EXPECT_EQ(trial.add({touch(1, 0.0), touch(2, 0.0)}, before), 0U);
  EXPECT_EQ(trial.add({touch(1, 0.0), touch(2, 0.0), touch(3, 0.0), touch(4, 0.0)}), 2U);
  trial.add({touch(2, 0.0), touch(4, 0.0)});
  trial.tracker.finish();
  std::map<std::uint32_t, Unfinished> flags;
  for (const auto& collision : trial.ended) flags[collision.particle] = collision.unfinished;
  EXPECT_EQ(flags, (std::map<std::uint32_t, Unfinished>{{1, Unfinished::began_before},
                                                        {2, Unfinished::both},
                                                        {3, Unfinished::none},
                                                        {4, Unfinished::open_at_end}}));
}

TEST(CollisionTracker, IntegratesNothingBeforeTheMeasurement) {
  Trial trial;
  trial.add({touch(1, 0.0)}, before);
  trial.add({});
  ASSERT_EQ(trial.ended.size(), 1U);
  EXPECT_EQ(trial.ended.front().sliding_work, 0.0);
  EXPECT_EQ(trial.ended.front().slip_distance, 0.0);
  EXPECT_EQ(trial.ended.front().largest_normal_force, 0.0);
}

// 100 N on each of two triangles of one side, then 100 N - 30 N where damping pulls: 200 N. Work
// adds up, the way that the ball slips does not: 0.5 m/s * 0.01 s in each of the two samples.
TEST(CollisionTracker, SimultaneousContactsOnOneSidePressTogether) {
  Trial trial;
  auto pulling = touch(1, 5.0 * degree, 1);
  pulling.normal_force = -30.0;
  trial.add({touch(1, 0.0, 0), touch(1, 5.0 * degree, 1)});
  trial.add({touch(1, 0.0, 0), pulling});
  trial.add({});
  ASSERT_EQ(trial.ended.size(), 1U);
  EXPECT_EQ(trial.ended.front().largest_normal_force, 200.0);
  EXPECT_DOUBLE_EQ(trial.ended.front().sliding_work, 3 * 0.5);
  EXPECT_DOUBLE_EQ(trial.ended.front().slip_distance, 2 * 0.005);
}

TEST(CollisionTracker, APullBesideAPushLowersTheLargestForce) {
  Trial trial;
  auto pulling = touch(1, 5.0 * degree, 1);
  pulling.normal_force = -30.0;
  trial.add({touch(1, 0.0, 0), pulling});
  trial.add({});
  EXPECT_EQ(trial.ended.front().largest_normal_force, 70.0);
}

TEST(CollisionTracker, AGrazingOrLeavingImpactHasAnAngleOfZero) {
  Trial trial;
  auto leaving = touch(1, 0.0);
  leaving.impact_normal_speed = -0.5;
  auto resting = touch(2, 0.0);
  resting.impact_speed = resting.impact_normal_speed = 0.0;
  auto straight = touch(3, 0.0);
  straight.impact_normal_speed = straight.impact_speed;
  trial.add({leaving, resting, straight});
  trial.add({});
  EXPECT_EQ(trial.ended[0].impact_angle, 0.0);
  EXPECT_EQ(trial.ended[1].impact_angle, 0.0);
  EXPECT_DOUBLE_EQ(trial.ended[2].impact_angle, 90.0 * degree);
}

TEST(CollisionTracker, RefusesAParticleThatTheChargeDoesNotHave) {
  Trial trial;
  EXPECT_THROW(trial.add({touch(0, 0.0)}), ResultRejected);
  EXPECT_THROW(trial.add({touch(11, 0.0)}), ResultRejected);
}

/// Sums may differ in the last bit with the order in which they are taken.
double rounded(double sum) { return std::round(sum * 1e10) / 1e10; }

auto fields(const Collision& c) {
  return std::tuple(c.start, c.end, c.particle, rounded(c.largest_normal_force),
                    rounded(c.normal_dissipation), rounded(c.sliding_work),
                    rounded(c.shear_dissipation), rounded(c.slip_distance), c.unfinished);
}

std::vector<decltype(fields(Collision{}))> in_order(const std::vector<Collision>& collisions) {
  std::vector<decltype(fields(Collision{}))> all;
  for (const auto& collision : collisions) all.push_back(fields(collision));
  std::sort(all.begin(), all.end());
  return all;
}

/// One of 36 angles around the ball, none as far from one as from another: a tie may fall either
/// way.
double uneven_angle(int i) { return degree * (10.0 * i + 3.0 * std::sin(1.7 * i * i)); }

/// Samples of contacts of three particles anywhere around the ball, forces of either
/// sign, a triangle at most once a particle.
using Samples = std::vector<std::vector<WallContact>>;
rc::Gen<Samples> any_samples() {
  using Drawn = std::map<std::pair<int, int>, int>;
  const auto sample = rc::gen::map(
      rc::gen::container<Drawn>(rc::gen::pair(rc::gen::inRange(1, 4), rc::gen::inRange(0, 36)),
                                rc::gen::inRange(-20, 100)),
      [](const Drawn& drawn) {
        std::vector<WallContact> contacts;
        for (const auto& [place, force] : drawn) {
          contacts.push_back(touch(static_cast<std::size_t>(place.first),
                                   uneven_angle(place.second),
                                   static_cast<std::size_t>(place.second)));
          contacts.back().normal_force = force;
        }
        return contacts;
      });
  return rc::gen::container<Samples>(sample);
}

RC_GTEST_PROP(CollisionTracker, TheOrderOfContactsInASampleDoesNotMatter, ()) {
  const Samples samples = *any_samples();
  Trial here;
  Trial there;
  for (const auto& contacts : samples) {
    auto other = contacts;
    std::reverse(other.begin(), other.end());
    RC_ASSERT(here.add(contacts) == there.add(other));
  }
  here.tracker.finish();
  there.tracker.finish();
  RC_ASSERT(in_order(here.ended) == in_order(there.ended));
}

/// What the tracker is to do, for contacts on the four sides of a ball: a particle's side is in
/// contact over a run of samples, and every run is a collision.
std::vector<Collision> runs_of(const Samples& samples) {
  std::vector<Collision> runs;
  std::map<std::pair<std::size_t, std::size_t>, std::optional<Collision>> open;
  for (std::size_t s = 0; s <= samples.size(); ++s) {
    std::map<std::pair<std::size_t, std::size_t>, double> force;
    if (s < samples.size())
      for (const auto& contact : samples[s])
        force[{contact.particle, contact.triangle}] += contact.normal_force;
    for (auto& [side, run] : open) {
      if (!run || force.contains(side)) continue;
      runs.push_back(*run);
      run.reset();
    }
    for (const auto& [side, pressed] : force) {
      auto& run = open[side];
      if (!run) {
        run = Collision{};
        run->start = dt * static_cast<double>(s);
        run->particle = static_cast<std::uint32_t>(side.first);
      }
      run->end = dt * static_cast<double>(s);
      run->largest_normal_force = std::max(run->largest_normal_force, pressed);
      if (s + 1 == samples.size()) run->unfinished = Unfinished::open_at_end;
    }
  }
  return runs;
}

RC_GTEST_PROP(CollisionTracker, EveryUnbrokenRunOnOneSideIsOneCollision, ()) {
  Samples samples = *any_samples();
  for (auto& contacts : samples)
    for (auto& contact : contacts) {
      contact.triangle /= 9;
      contact.into_wall = touch(1, 90.0 * degree * static_cast<double>(contact.triangle)).into_wall;
    }
  Trial trial;
  for (const auto& contacts : samples) trial.add(contacts);
  trial.tracker.finish();
  const auto key = [](const Collision& c) {
    return std::tuple(c.particle, c.start, c.end, c.largest_normal_force, c.unfinished);
  };
  std::vector<decltype(key(Collision{}))> found;
  std::vector<decltype(key(Collision{}))> wanted;
  for (const auto& c : trial.ended) found.push_back(key(c));
  for (const auto& c : runs_of(samples)) wanted.push_back(key(c));
  std::sort(found.begin(), found.end());
  std::sort(wanted.begin(), wanted.end());
  RC_ASSERT(found == wanted);
}

// Every particle changes between two ranks as the drawn bits say, before any sample.
RC_GTEST_PROP(CollisionTracker, TwoRanksSeeTheSameCollisionsAsOne, ()) {
  const Samples samples = *any_samples();
  const auto moves = *rc::gen::container<std::vector<int>>(samples.size(), rc::gen::inRange(0, 8));
  Trial whole;
  Trial ranks[2];
  const auto rank_of = [&](std::size_t s, std::size_t particle) {
    return (moves[s] >> (particle - 1)) & 1;
  };
  for (std::size_t s = 0; s < samples.size(); ++s) {
    for (int r = 0; r < 2; ++r)
      for (const auto& open : ranks[r].tracker.release(
               [&](std::uint32_t particle) { return rank_of(s, particle) != r; }))
        ranks[1 - r].tracker.adopt(open);
    whole.add(samples[s]);
    std::vector<WallContact> part[2];
    for (const auto& contact : samples[s]) part[rank_of(s, contact.particle)].push_back(contact);
    for (int r = 0; r < 2; ++r) ranks[r].add(part[r]);
  }
  whole.tracker.finish();
  for (auto& rank : ranks) rank.tracker.finish();
  auto both = ranks[0].ended;
  both.insert(both.end(), ranks[1].ended.begin(), ranks[1].ended.end());
  RC_ASSERT(in_order(both) == in_order(whole.ended));
}

}  // namespace
}  // namespace millwear::wear
