#include "liggghts_inputs/decks/charge_packing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mill/base/failure.h"
#include "mill/liner/mill_frame.h"
#include "tests/support/example_case.h"

namespace millwear::liggghts {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

double radius_of(const Case& mill, const PlacedParticle& particle) {
  return 0.5 * mill.charge.classes[particle.particle_class].diameter;
}

/// Least gap between any two particles [m], negative where they overlap. Compares all with all.
double least_gap(const Case& mill, const std::vector<PlacedParticle>& charge) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < charge.size(); ++i)
    for (std::size_t j = i + 1; j < charge.size(); ++j) {
      Eigen::Vector3d apart = charge[i].centre - charge[j].centre;
      apart.y() = std::abs(apart.y());
      apart.y() = std::min(apart.y(), mill.slice_length - apart.y());
      least =
          std::min(least, apart.norm() - radius_of(mill, charge[i]) - radius_of(mill, charge[j]));
    }
  return least;
}

/// The liner's whole outline (x, z) around the mill, at mill angle 0.
std::vector<Eigen::Vector2d> outline(const LinerProfile& liner) {
  std::vector<Eigen::Vector2d> ring;
  for (int row = 0; row < liner.sector.rows; ++row)
    for (std::size_t i = 0; i + 1 < liner.nodes.size(); ++i)
      ring.push_back(to_mill(liner.sector, liner.nodes[i], row, 0.0));
  return ring;
}

/// How far a place is from the outline [m], negative outside of it, in the steel.
double clearance(const std::vector<Eigen::Vector2d>& ring, const Eigen::Vector2d& place) {
  bool inside = false;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d a = ring[i];
    const Eigen::Vector2d along = ring[(i + 1) % ring.size()] - a;
    const double t = std::clamp((place - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (a + t * along - place).norm());
    const double share = (place.y() - a.y()) / along.y();
    if (share >= 0.0 && share < 1.0 && place.x() < a.x() + share * along.x()) inside = !inside;
  }
  return inside ? nearest : -nearest;
}

double least_clearance(const Case& mill, const std::vector<PlacedParticle>& charge) {
  const auto ring = outline(mill.liner);
  double least = std::numeric_limits<double>::infinity();
  for (const auto& particle : charge)
    least = std::min(least, clearance(ring, {particle.centre.x(), particle.centre.z()}) -
                                radius_of(mill, particle));
  return least;
}

TEST(PackCharge, PlacesEveryParticleApartAndOutOfTheSteel) {
  const Case mill = example_case();
  const auto charge = pack_charge(mill);
  for (std::size_t c = 0; c < mill.charge.classes.size(); ++c)
    EXPECT_EQ(std::ranges::count(charge, c, &PlacedParticle::particle_class),
              static_cast<long>(mill.charge.classes[c].count));
  EXPECT_GE(least_gap(mill, charge), 0.0);
  EXPECT_GE(least_clearance(mill, charge), 0.0);
  for (const auto& particle : charge) {
    EXPECT_GE(particle.centre.y(), 0.0);
    EXPECT_LT(particle.centre.y(), mill.slice_length);
  }
}

RC_GTEST_PROP(PackCharge, KeepsAnyChargeApartInAnySlice, ()) {
  Case mill = example_case();
  mill.slice_length = 0.001 * *rc::gen::inRange(100, 200);
  mill.dem.seed = *rc::gen::arbitrary<std::uint64_t>();
  mill.charge.classes = {{0, 0.001 * *rc::gen::inRange(40, 50), 60},
                         {1, 0.001 * *rc::gen::inRange(20, 40), 120},
                         {0, 0.001 * *rc::gen::inRange(5, 20), 120}};
  const auto charge = pack_charge(mill);
  RC_ASSERT(charge.size() == 300u);
  RC_ASSERT(least_gap(mill, charge) >= 0.0);
  RC_ASSERT(least_clearance(mill, charge) >= 0.0);
}

TEST(PackCharge, SameSeedGivesTheSameBytesAndAnotherSeedDoesNot) {
  Case mill = example_case();
  const auto first = charge_data_file(mill, pack_charge(mill));
  EXPECT_EQ(charge_data_file(mill, pack_charge(mill)), first);
  mill.dem.seed = 2;
  EXPECT_NE(charge_data_file(mill, pack_charge(mill)), first);
}

// A circle's part below a level that leans by 40 degrees has its middle 40 degrees from six
// o'clock.
TEST(PackCharge, LiesLowAndLeansToTheRisingSide) {
  Case mill = example_case();
  mill.charge.classes = {{0, 0.03, 1500}};
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& particle : pack_charge(mill)) middle += particle.centre / 1500.0;
  EXPECT_LT(middle.z(), 0.0);
  EXPECT_NEAR(angle_from_six_oclock(middle.x(), middle.z()) * 180.0 / std::numbers::pi, 40.0, 5.0);
}

// 200 balls of 100 mm are 0.105 m3 of steel; 0.2 m of the mill hold less than 0.157 m3, and balls
// thrown in at random jam near 38 % of it.
TEST(PackCharge, RefusesAChargeThatDoesNotFit) {
  Case mill = example_case();
  mill.charge.classes = {{0, 0.1, 200}};
  EXPECT_THAT([&] { static_cast<void>(pack_charge(mill)); },
              ThrowsMessage<InputError>(HasSubstr("of 200 particles of 0.1 m find no place")));
}

TEST(ChargeDataFile, HoldsTheChargeInABoxAroundTheShell) {
  const Case mill = example_case();
  const auto text = charge_data_file(mill, {{{0.1, 0.05, -0.4}, 0}, {{-0.1, 0.15, -0.3}, 2}});
  EXPECT_THAT(text, StartsWith("# charge of example\n\n2 atoms\n2 atom types\n-"));
  EXPECT_THAT(text, EndsWith(" 0.5304 xlo xhi\n0 0.2 ylo yhi\n-0.5304 0.5304 zlo zhi\n\nAtoms\n\n"
                             "1 1 0.05 7800 0.1 0.05 -0.4\n2 2 0.02 2700 -0.1 0.15 -0.3\n"));
}

// The centroid of a half-filled circle is 4 R / 3 pi from its centre; it is carried up to 0.83 of
// that beside the axis, and the box's middle is there.
TEST(ChargeDataFile, HasTheMovingChargeInItsMiddle) {
  Case mill = example_case();
  const double share = 0.5 / computed_filling(mill);
  for (auto& kind : mill.charge.classes)
    kind.count = static_cast<std::size_t>(static_cast<double>(kind.count) * share);
  const auto text = charge_data_file(mill, {});
  const double low = std::stod(text.substr(text.find("types\n") + 6));
  const double centroid = 4.0 * mill.liner.sector.plate_radius / (3.0 * std::numbers::pi);
  EXPECT_NEAR(0.5 * (low + 0.5304), -0.83 * centroid, 0.02 * centroid);
}

}  // namespace
}  // namespace millwear::liggghts
