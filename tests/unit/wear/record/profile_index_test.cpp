#include "wear/record/profile_index.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/sample_profiles.h"

namespace millwear::wear {
namespace {

TEST(ProfileIndex, FindsThePlaceOnAFace) {
  const LinerProfile profile = square_lifter();
  const auto lengths = arc_lengths(profile);
  const auto place = ProfileIndex(profile, 0.01).nearest({0.053, 0.04});
  EXPECT_NEAR(place.arc_length, lengths[4] + 0.06, 1e-12);
  EXPECT_NEAR(place.distance, 0.003, 1e-12);
}

// 1 mm beyond the sector's edge lies the next pitch: its first metre, not the last of this one.
TEST(ProfileIndex, FindsTheNeighbouringPitch) {
  const LinerProfile profile = bare_ring();
  const double beyond = 0.5 * sample_sector.pitch() + 1e-3;
  const auto place = ProfileIndex(profile, 0.01).nearest(point_at(sample_sector, 1.0, beyond));
  EXPECT_NEAR(place.arc_length, 1e-3, 1e-6);
}

TEST(ProfileIndex, AgreesWithComparingAllSegments) {
  const LinerProfile profile = square_lifter();
  const ProfileIndex index(profile, 0.05);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> xi(-0.4, 0.4);
  std::uniform_real_distribution<double> eta(-0.15, 0.25);
  for (int trial = 0; trial < 2000; ++trial) {
    const Eigen::Vector2d point(xi(random), eta(random));
    double least = 1e9;
    for (const int pitch : {-1, 0, 1}) {
      for (std::size_t i = 0; i + 1 < profile.nodes.size(); ++i) {
        const auto a = shifted_by_pitches(profile.sector, profile.nodes[i], pitch);
        const Eigen::Vector2d d =
            shifted_by_pitches(profile.sector, profile.nodes[i + 1], pitch) - a;
        const double t = std::clamp((point - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (point - a - t * d).norm());
      }
    }
    EXPECT_NEAR(index.nearest(point).distance, least, 1e-12);
  }
}

}  // namespace
}  // namespace millwear::wear
