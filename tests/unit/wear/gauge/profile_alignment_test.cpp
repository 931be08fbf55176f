#include "wear/gauge/profile_alignment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "mill/base/failure.h"
#include "mill/liner/parametric_lifter.h"
#include "mill/liner/profile_crossing.h"
#include "wear/evolve/signed_surface.h"
#include "wear/gauge/alignment_fit.h"

namespace millwear::wear {
namespace {

const LinerSector sector{1.05, 1.0, 10};
constexpr double degree = 0.017453292519943295;
constexpr double error = 1e-3;

/// Leans more at the back than in front, so that it is not its own mirror image.
LinerProfile fresh() { return profile_of(sector, {0.12, 0.08, 0.15, 0.6}); }

/// The crest cut to `height` and the leading face worn off from `face` on; the back stays.
LinerProfile worn(double height, double face) {
  const Curve dense = even_places(fresh(), 800);
  LinerProfile profile{sector, {fresh().nodes.front()}};
  for (const auto& place : dense) {
    Eigen::Vector2d node = place;
    if (radius_of(sector, node) < sector.plate_radius - 0.004) {
      node = {std::min(node.x(), face), std::min(node.y(), height)};
    }
    profile.nodes.push_back(node);
  }
  profile.nodes.push_back(fresh().nodes.back());
  return profile;
}

/// Small counter-based scatter, nearly normal with standard deviation 1.
double scatter(std::uint64_t counter) {
  double sum = 0.0;
  for (int k = 0; k < 12; ++k) {
    std::uint64_t z = (12 * counter + k + 1) * 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    sum += static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
  return sum - 6.0;
}

Curve with_noise(Curve curve, double deviation) {
  for (std::size_t i = 0; i < curve.size(); ++i)
    curve[i] += deviation * Eigen::Vector2d(scatter(2 * i), scatter(2 * i + 1));
  return curve;
}

Curve moved_by(const Curve& curve, const RigidMotion& motion) {
  Curve result;
  for (const auto& node : curve) result.push_back(motion(node));
  return result;
}

double farthest_node(const Curve& a, const Curve& b) {
  double farthest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) farthest = std::max(farthest, (a[i] - b[i]).norm());
  return farthest;
}

std::string refusal(const LinerProfile& reference, const Curve& curve) {
  try {
    static_cast<void>(aligned_by_fit(reference, curve, error));
  } catch (const InputError& refused) {
    return refused.what();
  }
  return "";
}

const RigidMotion gauge_frame{4.0 * degree, {0.031, -0.022}};

TEST(FittedProfile, ComesBackFromTheGaugesFrame) {
  const Curve truth = fresh().nodes;
  const auto fitted = aligned_by_fit(fresh(), moved_by(truth, gauge_frame), error);
  EXPECT_LT(farthest_node(fitted.curve.nodes, truth), 1e-8);
  EXPECT_NEAR(fitted.curve.motion.angle, -4.0 * degree, 1e-8);
  EXPECT_FALSE(fitted.curve.reversed);
  EXPECT_GT(fitted.quality.used_share, 0.999);
  EXPECT_LT(fitted.quality.rms, 1e-8);
}

// Half of the curve is worn away, its crest by 50 mm and its leading face by 40.
TEST(FittedProfile, LeavesOutWhatIsWorn) {
  const Curve truth = worn(0.07, 0.02).nodes;
  const auto fitted = aligned_by_fit(fresh(), moved_by(truth, gauge_frame), error);
  EXPECT_LT(farthest_node(fitted.curve.nodes, truth), 2e-5);
  EXPECT_LT(fitted.quality.used_share, 0.8);
  EXPECT_GT(fitted.quality.used_share, 0.5);
}

// Noise of 1 mm on 800 places: the fit is known to a few hundredths of it... a tenth at the ends.
TEST(FittedProfile, NoiseAveragesOut) {
  const Curve truth = worn(0.07, 0.02).nodes;
  const auto fitted =
      aligned_by_fit(fresh(), with_noise(moved_by(truth, gauge_frame), error), error);
  EXPECT_LT(farthest_node(moved_by(moved_by(truth, gauge_frame), fitted.curve.motion), truth),
            0.25 * error);
  EXPECT_NEAR(fitted.quality.rms, 0.7 * error, 0.4 * error);
}

// A gauge's frame of any turn and far away; nodes in the opposite order.
TEST(FittedProfile, FindsAnyFrameAndOrder) {
  const Curve truth = worn(0.07, 0.02).nodes;
  for (const double turn : {-170.0, 37.0}) {
    Curve seen = moved_by(truth, {turn * degree, {12.0, -7.0}});
    std::reverse(seen.begin(), seen.end());
    const auto fitted = aligned_by_fit(fresh(), seen, error);
    EXPECT_LT(farthest_node(fitted.curve.nodes, truth), 5e-5) << turn;
    EXPECT_TRUE(fitted.curve.reversed);
  }
}

TEST(FittedProfile, SaysWhenItIsSeenFromTheOtherEnd) {
  const Curve truth = worn(0.07, 0.02).nodes;
  const Curve seen = moved_by(mirror_image(truth), gauge_frame);
  EXPECT_THAT(refusal(fresh(), seen), testing::HasSubstr("mirror image fits the reference better"));
  const auto fitted = aligned_by_fit(fresh(), mirror_image(seen), error);
  EXPECT_LT(farthest_node(fitted.curve.nodes, truth), 5e-5);
}

// Nothing stands out of the new liner, however much is worn.
TEST(FittedProfile, IsNotPulledOutwards) {
  for (const double height : {0.1, 0.04}) {
    const Curve truth = worn(height, 0.0).nodes;
    const auto fitted = aligned_by_fit(fresh(), moved_by(truth, gauge_frame), error);
    EXPECT_LT(farthest_node(fitted.curve.nodes, truth), 1e-4) << height;
  }
}

TEST(FittedProfile, RefusesAPlateAlone) {
  Curve plate;
  for (int i = -50; i <= 50; ++i) plate.push_back(point_at(sector, 1.0, 0.003 * i));
  EXPECT_THAT(refusal(fresh(), plate), testing::HasSubstr("ambiguous"));
}

TEST(FittedProfile, RefusesAnotherLifter) {
  const auto other = profile_of(sector, {0.2, 0.2, 0.0, 0.0});
  EXPECT_NE(refusal(fresh(), other.nodes), "");
}

TEST(FittedProfile, RefusesMoreScatterThanItsError) {
  EXPECT_THAT(refusal(fresh(), with_noise(even_places(fresh(), 400), 4e-3)),
              testing::HasSubstr("error"));
}

TEST(AlignedEnds, WholePitchGoesToTheEdges) {
  const Curve truth = worn(0.07, 0.02).nodes;
  Curve seen = moved_by(truth, {40.0 * degree, {3.0, 1.0}});
  const auto aligned = aligned_by_ends(fresh(), seen, sector.plate_radius, error);
  EXPECT_NEAR(angle_of(sector, aligned.nodes.front()), -0.5 * sector.pitch(), 1e-12);
  EXPECT_FALSE(aligned.reversed);
  EXPECT_LT(farthest_node(moved_by(seen, aligned.motion), truth), 1e-12);

  std::reverse(seen.begin(), seen.end());
  const auto reversed = aligned_by_ends(fresh(), seen, sector.plate_radius, error);
  EXPECT_TRUE(reversed.reversed);
  EXPECT_LT(farthest_node(reversed.nodes, aligned.nodes), 1e-12);
}

// The plate is worn by 20 mm and everything with it: the gauge cannot know, the caller says it.
TEST(AlignedEnds, StandOnThePlateThatIsSaid) {
  const LinerSector deeper{1.05, 1.02, 10};
  Curve truth = profile_of(deeper, {0.05, 0.08, 0.15, 0.6}).nodes;
  for (auto& node : truth) node.y() -= 0.02;
  const auto aligned = aligned_by_ends(fresh(), moved_by(truth, {0.2, {1.0, 1.0}}), 1.02, error);
  EXPECT_LT(farthest_node(aligned.nodes, truth), 1e-12);
}

// A lifter from foot to foot on a plate worn by 20 mm.
TEST(AlignedEnds, BareLifterGetsItsPlate) {
  const LinerSector deeper{1.05, 1.02, 10};
  const auto whole = profile_of(deeper, {0.05, 0.08, 0.3, 0.3});
  Curve bare;
  for (const auto& node : whole.nodes)
    if (std::abs(node.x()) < 0.06) bare.push_back(node);
  ASSERT_EQ(bare.size(), 4U);
  const auto aligned = aligned_by_ends(fresh(), moved_by(bare, {0.2, {1.0, 1.0}}), 1.02, error);
  EXPECT_NEAR(radius_of(sector, aligned.nodes.front()), 1.02, 1e-12);
  EXPECT_NEAR(angle_of(sector, aligned.nodes.back()), 0.5 * sector.pitch(), 1e-12);
  EXPECT_GT(aligned.nodes.size(), bare.size() + 4);
  EXPECT_EQ(first_crossing({sector, aligned.nodes}), std::pair(-1, -1));
}

TEST(AlignedEnds, RefusesEndsTooFarApart) {
  const Curve twice = {{-0.4, 0.0}, {0.0, 0.1}, {0.4, 0.0}};
  EXPECT_THROW(static_cast<void>(aligned_by_ends(fresh(), twice, 1.0, error)), InputError);
  const Curve closed = {{0.0, 0.0}, {0.0, 0.1}, {0.0, 0.0}};
  EXPECT_THROW(static_cast<void>(aligned_by_ends(fresh(), closed, 1.0, error)), InputError);
}

TEST(KeptInPlace, TurnsTheOrderOnly) {
  Curve backward = fresh().nodes;
  std::reverse(backward.begin(), backward.end());
  EXPECT_EQ(kept_in_place(sector, backward).nodes, fresh().nodes);
  EXPECT_TRUE(kept_in_place(sector, backward).reversed);
  EXPECT_FALSE(kept_in_place(sector, fresh().nodes).reversed);
}

}  // namespace
}  // namespace millwear::wear
