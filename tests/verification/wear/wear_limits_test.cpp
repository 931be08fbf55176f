#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "mill/base/failure.h"
#include "mill/liner/profile_crossing.h"
#include "mill/liner/profile_measures.h"
#include "tests/support/sample_profiles.h"
#include "tests/verification/wear/random_liners.h"
#include "wear/evolve/evolution.h"

namespace millwear::wear {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr Eigen::Index bins = 150;
constexpr double metre_a_second = 1.0;

/// The load at the centres of even bins, by arc length.
ArcCurve load_along(const LinerProfile& profile, const std::function<double(double)>& rate) {
  ArcCurve load{Eigen::VectorXd::LinSpaced(bins + 1, 0.0, arc_lengths(profile).back()),
                Eigen::VectorXd(bins)};
  for (Eigen::Index i = 0; i < bins; ++i)
    load.values[i] = rate((static_cast<double>(i) + 0.5) * load.bin_width());
  return load;
}

auto between_lengths(double from, double to) {
  return [from, to](double s) { return s > from && s < to ? metre_a_second : 0.0; };
}

Evolution evolved(const LinerProfile& profile, const ArcCurve& load,
                  const CampaignSettings& settings) {
  return evolve(std::vector<TimedLoad>{{0.0, profile, load}}, lifter_area(profile), settings);
}

/// What every evolution owes: valid profiles, no steel gained, and an account that closes.
void expect_sound(const LinerProfile& first, const Evolution& evolution) {
  ASSERT_FALSE(evolution.steps.empty());
  const LinerProfile* before = &first;
  double booked = 0.0;
  for (const auto& step : evolution.steps) {
    EXPECT_EQ(first_crossing(step.profile), std::pair(-1, -1));
    EXPECT_LE(gained(*before, step.profile), 3e-9 * arc_lengths(*before).back());
    booked += step.accounted_area + step.fallen_area;
    before = &step.profile;
  }
  EXPECT_NEAR(steel_area(first) - steel_area(*before), booked, 1e-8 * booked);
}

double fallen_area(const Evolution& evolution) {
  return std::accumulate(evolution.steps.begin(), evolution.steps.end(), 0.0,
                         [](double sum, const auto& step) { return sum + step.fallen_area; });
}

/// A lifter 20 mm wide and 150 mm high.
LinerProfile tall_thin_lifter() {
  LinerProfile profile = square_lifter();
  profile.nodes[2] = {-0.01, 0.0};
  profile.nodes[3] = {-0.01, 0.15};
  profile.nodes[4] = {0.01, 0.15};
  profile.nodes[5] = {0.01, 0.0};
  return profile;
}

// The lifter wears three times as fast as the plate. Once it is gone, a hollow is left where it
// stood, and the crest is the plate's own, 10 mm below where it was when new.
TEST(WearLimits, LifterGoesBelowThePlate) {
  const auto profile = square_lifter();
  const auto lengths = arc_lengths(profile);
  const auto load =
      load_along(profile, [&](double s) { return s > lengths[2] && s < lengths[5] ? 3.0 : 1.0; });
  const auto evolution = evolved(profile, load, {4.0, 80, -0.01, 0.0, 1});
  EXPECT_EQ(evolution.end, EvolutionEnd::height_limit);
  expect_sound(profile, evolution);
  const auto& last = evolution.steps.back().profile;
  EXPECT_LE(lifter_height(last), -0.01 + 1e-6);
  EXPECT_GT(lifter_height(last), -0.01 - 1e-4) << "a burr at the edge of the hollow goes at once";
  EXPECT_GT(plate_thickness(last), 0.0);
  EXPECT_NEAR(lifter_area(last), 0.0, 1e-15);
}

// A ring, worn evenly and through: what went is the annulus between the plate and the shell, of
// which the 40 facets leave R pitch^2 / 12 / 40^2 of their depth.
TEST(WearLimits, PlateWearsThroughEvenly) {
  const auto ring = bare_ring();
  const auto load = load_along(ring, [](double) { return metre_a_second; });
  const auto evolution =
      evolve(std::vector<TimedLoad>{{0.0, ring, load}}, 0.01, {10.0, 20, -1.0, 0.0, 1});
  EXPECT_EQ(evolution.end, EvolutionEnd::plate_limit);
  expect_sound(ring, evolution);
  const auto& last = evolution.steps.back().profile;
  EXPECT_NEAR(plate_thickness(last), 0.0, 1e-6);
  const double annulus = 0.5 * sample_sector.pitch() * (1.05 * 1.05 - 1.0);
  EXPECT_NEAR(steel_area(ring) - steel_area(last), annulus, 1e-3 * annulus);
}

// The plate wears in front of the lifter only: a trough, and the shell shows at one place.
TEST(WearLimits, PlateWearsThroughAtOnePlace) {
  const auto profile = square_lifter();
  const double foot = arc_lengths(profile)[5];
  const auto load = load_along(profile, between_lengths(foot + 0.03, foot + 0.06));
  const auto evolution = evolved(profile, load, {1.0, 10, 0.0, 0.0, 1});
  EXPECT_EQ(evolution.end, EvolutionEnd::plate_limit);
  expect_sound(profile, evolution);
  EXPECT_NEAR(plate_thickness(evolution.steps.back().profile), 0.0, 1e-6);
  EXPECT_EQ(lifter_height(evolution.steps.back().profile), lifter_height(profile));
}

/// What wears where the leading face was between 20 and 50 mm over its foot, and behind it.
ArcCurve load_in_the_notch(const LinerProfile& profile) {
  const auto lengths = arc_lengths(profile);
  return load_along(profile, [&](double s) {
    const Eigen::Vector2d place = place_at(profile, lengths, s);
    const bool in_notch =
        place.y() > 0.02 && place.y() < 0.05 && place.x() > -0.049 && place.x() < 0.06;
    return in_notch ? metre_a_second : 0.0;
  });
}

// The notch grows until what is above has no hold and falls: the lifter's head, 100 mm wide and
// 50 mm high. Half-way through the trailing face is nearer than the one that was loaded, which
// spends the load; the next is measured in the notch.
TEST(WearLimits, UndercutLifterLosesItsHead) {
  LinerProfile profile = square_lifter();
  double fallen = 0.0;
  EvolutionEnd end = EvolutionEnd::load_spent;
  for (int cycle = 0; cycle < 10 && end == EvolutionEnd::load_spent; ++cycle) {
    EXPECT_NEAR(lifter_height(profile), 0.1, 1e-15);
    const auto evolution = evolved(profile, load_in_the_notch(profile), {1.0, 40, 0.07, 0.0, 1});
    expect_sound(profile, evolution);
    fallen += fallen_area(evolution);
    profile = evolution.steps.back().profile;
    end = evolution.end;
  }
  EXPECT_EQ(end, EvolutionEnd::height_limit);
  EXPECT_LT(lifter_height(profile), 0.05);
  EXPECT_NEAR(fallen, 0.1 * 0.05, 0.1 * 0.01);
}

// Both faces of a fin are cut at its root, 20 mm high: 20 mm x 130 mm fall.
TEST(WearLimits, FinFallsOff) {
  const auto profile = tall_thin_lifter();
  const auto lengths = arc_lengths(profile);
  const auto trailing = between_lengths(lengths[2], lengths[2] + 0.02);
  const auto leading = between_lengths(lengths[5] - 0.02, lengths[5]);
  const auto load = load_along(profile, [&](double s) { return trailing(s) + leading(s); });
  const auto evolution = evolved(profile, load, {0.5, 30, 0.05, 0.0, 1});
  EXPECT_EQ(evolution.end, EvolutionEnd::height_limit);
  expect_sound(profile, evolution);
  EXPECT_NEAR(fallen_area(evolution), 0.02 * 0.13, 0.02 * 0.01);
}

// Both faces wear, the top does not: 10 mm from each side, and the whole fin is gone at once.
TEST(WearLimits, FinIsEatenFromBothFaces) {
  const auto profile = tall_thin_lifter();
  const auto lengths = arc_lengths(profile);
  const auto trailing = between_lengths(lengths[2], lengths[3]);
  const auto leading = between_lengths(lengths[4], lengths[5]);
  const auto load = load_along(profile, [&](double s) { return trailing(s) + leading(s); });
  const auto evolution = evolved(profile, load, {2.0, 40, 0.05, 0.0, 1});
  EXPECT_EQ(evolution.end, EvolutionEnd::height_limit);
  expect_sound(profile, evolution);
  EXPECT_LE(lifter_height(evolution.steps.back().profile), 0.05);
  double time = 0.0;
  for (const auto& step : evolution.steps) time += step.duration;
  EXPECT_NEAR(time, 0.01, 0.001);
}

// One sense of rotation: the leading face and the top's leading half wear, the trailing face stays
// to the last bit, and the face leans back farther with every step.
TEST(WearLimits, OneSenseOfRotationWearsOneFace) {
  const auto profile = square_lifter();
  const auto lengths = arc_lengths(profile);
  const auto load = load_along(profile, [&](double s) {
    return s < lengths[3] + 0.05 || s > lengths[5] ? 0.0
                                                   : std::exp(-std::abs(s - lengths[4]) / 0.02);
  });
  const auto evolution = evolved(profile, load, {0.15, 10, 0.0, 0.0, 1});
  expect_sound(profile, evolution);
  double angle = leading_face_angle(profile);
  for (const auto& step : evolution.steps) {
    const double next = leading_face_angle(step.profile);
    EXPECT_GT(next, angle - 1e-3);
    angle = next;
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_THAT(step.profile.nodes, testing::Contains(profile.nodes[i]));
  }
  EXPECT_GT(angle, 0.35);
}

// A hole one bin wide is as deep as its section is over its width, and then goes through.
TEST(WearLimits, OneBinTakesItAll) {
  const auto profile = square_lifter();
  const double foot = arc_lengths(profile)[5];
  const auto load = load_along(profile, between_lengths(foot + 0.04, foot + 0.047));
  ASSERT_EQ(load.values.sum(), 1.0);
  for (const double depth : {0.001, 0.01, 0.04, 0.06}) {
    const auto worn = worn_by(profile, load, depth * load.bin_width());
    EXPECT_EQ(first_crossing(worn.profile), std::pair(-1, -1));
    EXPECT_NEAR(worn.removed_area, depth * load.bin_width(), 1e-9 * depth);
    EXPECT_GT(sample_sector.shell_radius - plate_thickness(worn.profile), 1.0 + 0.8 * depth);
  }
}

TEST(WearLimits, MoreSteelThanThereIsIsRefused) {
  const auto profile = square_lifter();
  const auto everywhere = load_along(profile, [](double) { return metre_a_second; });
  EXPECT_THAT([&] { static_cast<void>(worn_by(profile, everywhere, steel_area(profile))); },
              ThrowsMessage<ResultRejected>(HasSubstr("shorten the step")));
  const double foot = arc_lengths(profile)[5];
  const auto one_place = load_along(profile, between_lengths(foot + 0.04, foot + 0.047));
  EXPECT_THAT([&] { static_cast<void>(worn_by(profile, one_place, 0.5 * steel_area(profile))); },
              ThrowsMessage<ResultRejected>(HasSubstr("shorten the step")));
}

// From what the grid of 1 nm still sees to where only the account is left.
TEST(WearLimits, VerySmallStepsKeepTheAccount) {
  const auto profile = square_lifter();
  const auto load = load_along(profile, [](double s) { return 1.0 + std::sin(10.0 * s); });
  for (int power = 15; power >= 5; --power) {
    const double area = std::pow(10.0, -power);
    const auto worn = worn_by(profile, load, area);
    EXPECT_EQ(first_crossing(worn.profile), std::pair(-1, -1));
    EXPECT_NEAR(steel_area(profile) - steel_area(worn.profile), area, 1e-9 * area + 4e-15) << power;
    EXPECT_LE(gained(profile, worn.profile), 3e-9);
    EXPECT_LT(worn.profile.nodes.size(), 600U);
  }
}

// A thousand steps of 1 um each are one of 1 mm: the account adds up, the shape is the same, and
// the nodes do not pile up.
TEST(WearLimits, ManySmallStepsAreOneLarge) {
  const auto profile = square_lifter();
  const auto load = load_along(profile, [](double s) { return 1.0 + std::sin(10.0 * s); });
  const double area = 3e-6;
  LinerProfile small = profile;
  for (int step = 0; step < 60; ++step) {
    const auto again = load_along(
        small, [&](double s) { return load.at(s * load.length() / arc_lengths(small).back()); });
    small = worn_by(small, again, area).profile;
    ASSERT_LT(small.nodes.size(), 900U);
  }
  EXPECT_NEAR(steel_area(profile) - steel_area(small), 60.0 * area, 1e-9 * 60.0 * area);
  EXPECT_LT(distance_between(small, worn_by(profile, load, 60.0 * area).profile), 1e-4);
}

}  // namespace
}  // namespace millwear::wear
