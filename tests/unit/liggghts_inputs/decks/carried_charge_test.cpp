#include "liggghts_inputs/decks/carried_charge.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "liggghts_inputs/decks/charge_packing.h"
#include "liggghts_inputs/decks/nearest_place.h"
#include "mill/base/failure.h"
#include "mill/liner/parametric_lifter.h"
#include "tests/support/example_case.h"
#include "tests/unit/liggghts_inputs/decks/charge_gaps.h"

namespace millwear::liggghts {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

Case with_lifter(Case mill, double height) {
  mill.liner = profile_of(mill.liner.sector, {height, 0.05, 0.3, 0.2});
  return mill;
}

/// The packing of a mill, each particle with a velocity and a spin that tell which it is.
std::vector<PlacedParticle> moving_charge(const Case& mill) {
  auto charge = pack_charge(mill);
  for (std::size_t i = 0; i < charge.size(); ++i) {
    charge[i].velocity = {static_cast<double>(i), 1.0, 2.0};
    charge[i].spin = {3.0, static_cast<double>(i), 4.0};
  }
  return charge;
}

const PlacedParticle& twin_of(const PlacedParticle& particle,
                              const std::vector<PlacedParticle>& charge) {
  return charge[static_cast<std::size_t>(particle.velocity.x())];
}

double shift_of(const PlacedParticle& particle, const std::vector<PlacedParticle>& charge,
                double slice) {
  const double shift = particle.centre.y() - twin_of(particle, charge).centre.y();
  return shift - slice * std::floor(shift / slice + 1e-9);
}

TEST(CarriedCharge, KeepsAllThatIsNotInTheSteel) {
  const Case mill = example_case();
  const auto source = moving_charge(mill);
  const auto carried = carried_charge(mill, source);
  EXPECT_EQ(carried.moved + carried.added + carried.left, 0U);
  ASSERT_EQ(carried.particles.size(), source.size());
  const double shift = shift_of(carried.particles.front(), source, mill.slice_length);
  for (const auto& particle : carried.particles) {
    const auto& twin = twin_of(particle, source);
    EXPECT_EQ(particle.centre.x(), twin.centre.x());
    EXPECT_EQ(particle.centre.z(), twin.centre.z());
    EXPECT_NEAR(shift_of(particle, source, mill.slice_length), shift, 1e-12);
    EXPECT_EQ(particle.velocity, twin.velocity);
    EXPECT_EQ(particle.spin, twin.spin);
    EXPECT_GE(particle.centre.y(), 0.0);
    EXPECT_LT(particle.centre.y(), mill.slice_length);
  }
}

TEST(CarriedCharge, GivesAnotherSeedAnotherShift) {
  Case mill = example_case();
  const auto source = moving_charge(mill);
  const auto first = carried_charge(mill, source).particles;
  EXPECT_EQ(carried_charge(mill, source).particles.front().centre, first.front().centre);
  mill.dem.seed = 2;
  EXPECT_NE(carried_charge(mill, source).particles.front().centre.y(), first.front().centre.y());
}

// A lifter of twice the height stands where particles lay; they go to the nearest room there is,
// and nothing else moves.
TEST(CarriedCharge, MovesWhatWouldLieInTheSteel) {
  const Case source_mill = example_case();
  const Case mill = with_lifter(source_mill, 0.08);
  const auto source = moving_charge(source_mill);
  const auto carried = carried_charge(mill, source);
  EXPECT_GT(carried.moved, 10U);
  EXPECT_LT(carried.moved, source.size() / 4);
  std::size_t moved = 0;
  for (const auto& particle : carried.particles)
    if (particle.centre.x() != twin_of(particle, source).centre.x()) ++moved;
  EXPECT_EQ(moved, carried.moved);
  EXPECT_GE(least_gap(mill, carried.particles), 0.0);
  EXPECT_GE(least_clearance(mill, carried.particles), -0.02 * 0.05);
}

TEST(CarriedCharge, HasTheCountsOfTheCase) {
  const Case source_mill = example_case();
  Case mill = source_mill;
  mill.charge.classes[0].count = 90;
  mill.charge.classes[1].count = 1100;
  const auto carried = carried_charge(mill, moving_charge(source_mill));
  EXPECT_EQ(carried.left, 10U);
  EXPECT_EQ(carried.added, 100U);
  EXPECT_EQ(carried.moved, 0U);
  for (std::size_t c = 0; c < mill.charge.classes.size(); ++c)
    EXPECT_EQ(std::ranges::count(carried.particles, c, &PlacedParticle::particle_class),
              static_cast<long>(mill.charge.classes[c].count));
  EXPECT_GE(least_gap(mill, carried.particles), 0.0);
}

TEST(CarriedCharge, RefusesAMillThatIsTooFull) {
  const Case source_mill = example_case();
  Case mill = source_mill;
  mill.charge.classes[0].count = 2000;
  EXPECT_THAT([&] { static_cast<void>(carried_charge(mill, moving_charge(source_mill))); },
              ThrowsMessage<InputError>(HasSubstr("finds no room in this mill")));
}

TEST(CarriedCharge, RefusesAClassWithoutParticles) {
  Case source_mill = example_case();
  source_mill.charge.classes[1].count = 0;
  EXPECT_THAT(
      [&] { static_cast<void>(carried_charge(example_case(), moving_charge(source_mill))); },
      ThrowsMessage<InputError>(HasSubstr("has no ore of 30 mm")));
}

TEST(SameCharge, MayHaveAnotherLinerSpeedAndCounts) {
  Case source = with_lifter(example_case(), 0.08);
  source.speed = 2.0;
  source.charge.classes[0].count = 5;
  EXPECT_NO_THROW(check_same_charge(example_case(), source));
}

TEST(SameCharge, NamesAllThatDiffers) {
  const Case mill = example_case();
  Case source = mill;
  source.liner.sector.shell_radius = 0.6;
  source.slice_length = 0.3;
  source.materials[1].density = 3000.0;
  EXPECT_THAT(
      [&] { check_same_charge(mill, source); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("the shell's diameter (1.04 m, there 1.2)"),
                                      HasSubstr("the slice's length (0.2 m, there 0.3)"),
                                      HasSubstr("the density of ore (2700 kg/m3, there 3000)"))));
  source = mill;
  source.charge.classes[2].diameter = 0.025;
  EXPECT_THAT(
      [&] { check_same_charge(mill, source); },
      ThrowsMessage<InputError>(AllOf(
          HasSubstr("the charge (steel of 0.05 m, ore of 0.03 m, ore of 0.02 m, there steel of "
                    "0.05 m, ore of 0.03 m, ore of 0.025 m)"),
          Not(HasSubstr("shell")))));
}

// Half a lattice's diagonal away at most while the place is empty, and further out once it is full.
TEST(NearestPlace, FillsUpFromTheCentre) {
  const Case mill = example_case();
  FreeSpace space(mill);
  const double diagonal = 0.5 * std::sqrt(3.0) * 0.5 * 0.02;
  const Eigen::Vector3d centre(0.013, 0.199, -0.217);
  NearestPlace nearest(space, mill, 2);
  for (int i = 0; i < 200; ++i) {
    const auto place = nearest.find(centre);
    ASSERT_TRUE(place);
    EXPECT_TRUE(space.is_free(*place, 2));
    Eigen::Vector3d apart = *place - centre;
    apart.y() -= mill.slice_length * std::round(apart.y() / mill.slice_length);
    if (i == 0) {
      EXPECT_LE(apart.norm(), diagonal + 1e-12);
    }
    space.take(*place, 2);
  }
  EXPECT_GT((*nearest.find(centre) - centre).norm(), 0.05);
}

}  // namespace
}  // namespace millwear::liggghts
