#include "recorder/neighbours/size_grids.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace millwear::recorder {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// Spheres with their centres kept as LIGGGHTS keeps them.
class Charge {
 public:
  void add(const std::array<double, 3>& centre, double radius) {
    places_.push_back(centre);
    radii_.push_back(radius);
  }

  [[nodiscard]] Spheres spheres() {
    centres_.clear();
    for (const auto& place : places_) centres_.push_back(place.data());
    return {centres_.data(), radii_};
  }

  [[nodiscard]] int size() const { return static_cast<int>(radii_.size()); }

  /// Every pair, one by one.
  [[nodiscard]] std::vector<int> later_neighbours(int i, const NeighbourReach& reach) const {
    std::vector<int> found;
    for (int j = i + 1; j < size(); ++j) {
      const double distance =
          std::hypot(places_[i][0] - places_[j][0], places_[i][1] - places_[j][1],
                     places_[i][2] - places_[j][2]);
      if (distance <= (radii_[i] + radii_[j]) * reach.stretch + reach.skin) found.push_back(j);
    }
    return found;
  }

 private:
  std::vector<std::array<double, 3>> places_;
  std::vector<double> radii_;
  std::vector<const double*> centres_;
};

std::vector<int> found_by(const SizeGrids& grids, int sphere) {
  std::vector<int> neighbours;
  grids.add_later_neighbours(sphere, neighbours);
  std::ranges::sort(neighbours);
  return neighbours;
}

/// `count` spheres with diameters from 8 to 180 mm, the small ones many, in a slice of a mill.
Charge random_charge(int count, unsigned seed) {
  std::mt19937 dice(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Charge charge;
  for (int i = 0; i < count; ++i)
    charge.add({share(dice), 0.25 * share(dice), -0.5 * share(dice)},
               0.004 * std::pow(22.5, std::pow(share(dice), 6)));
  return charge;
}

TEST(SizeGrids, FindWhatATestOfEveryPairFinds) {
  for (const NeighbourReach reach :
       {NeighbourReach{0.002}, NeighbourReach{0.03}, NeighbourReach{0.002, 1.3}}) {
    Charge charge = random_charge(2500, 7);
    const SizeGrids grids(charge.spheres(), reach);
    std::size_t pairs = 0;
    for (int i = 0; i < charge.size(); ++i) {
      const auto expected = charge.later_neighbours(i, reach);
      ASSERT_EQ(found_by(grids, i), expected) << "sphere " << i << ", skin " << reach.skin;
      pairs += expected.size();
    }
    EXPECT_GT(pairs, 3000u);
  }
}

// Radii 1 and 2 m, 4 m apart: 1 m lies between them.
TEST(SizeGrids, ReachBySkinAndStretch) {
  Charge charge;
  charge.add({0, 0, 0}, 1.0);
  charge.add({0, 4, 0}, 2.0);
  EXPECT_THAT(found_by(SizeGrids(charge.spheres(), {0.99}), 0), IsEmpty());
  EXPECT_THAT(found_by(SizeGrids(charge.spheres(), {1.0}), 0), ElementsAre(1));
  EXPECT_THAT(found_by(SizeGrids(charge.spheres(), {0.0, 1.5}), 0), ElementsAre(1));
  EXPECT_THAT(found_by(SizeGrids(charge.spheres(), {1.0}), 1), IsEmpty());
}

// The ball of 1 m reaches to 0.5 m from the box, within the skin of 0.6 m; the one of 0.1 m, with
// its centre 3 m from it, does not.
TEST(SizeGrids, FindWhatComesNearABox) {
  Charge charge;
  charge.add({0, 0, 2.5}, 1.0);
  charge.add({0, 0, -3.0}, 0.1);
  std::vector<int> spheres;
  SizeGrids(charge.spheres(), {0.6}).add_spheres_near({-3, -3, 0}, {3, 3, 1}, {1, 1, 1}, spheres);
  EXPECT_THAT(spheres, ElementsAre(0));

  // 0.1 + 0.6 m, four times over, reach the other as well: it is 3 m away.
  spheres.clear();
  SizeGrids(charge.spheres(), {0.6}).add_spheres_near({-3, -3, 0}, {3, 3, 1}, {1, 1, 4}, spheres);
  EXPECT_THAT(spheres, UnorderedElementsAre(0, 1));
}

// Of a triangle outside of a rank's part LIGGGHTS clips the box until its lower end is above its
// upper one. By more than they reach there is nothing near it.
TEST(SizeGrids, FindNothingNearABoxThatIsClippedAway) {
  Charge charge;
  for (int i = 0; i < 40; ++i) charge.add({1.0 * i, 0, 0}, 0.4);
  std::vector<int> spheres;
  const SizeGrids grids(charge.spheres(), {0.1});
  for (const double low : {22.0, 23.0, 27.0, 33.0})
    grids.add_spheres_near({low, -1, -1}, {20, 1, 1}, {1, 1, 1}, spheres);
  EXPECT_THAT(spheres, IsEmpty());
}

TEST(SizeGrids, MissNothingThatComesNearABox) {
  Charge charge = random_charge(2500, 11);
  constexpr Place low = {0.4, 0.0, -0.5};
  constexpr Place high = {0.7, 0.2, -0.45};
  constexpr double skin = 0.01;
  std::vector<int> found;
  SizeGrids(charge.spheres(), {skin}).add_spheres_near(low, high, {1, 1, 1}, found);
  std::ranges::sort(found);
  const Spheres all = charge.spheres();
  int near = 0;
  for (int i = 0; i < charge.size(); ++i) {
    double square = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double x = all.centres[i][axis];
      square += std::pow(x - std::clamp(x, low[axis], high[axis]), 2);
    }
    if (std::sqrt(square) > all.radii[i] + skin) continue;
    ++near;
    EXPECT_TRUE(std::ranges::binary_search(found, i)) << i;
  }
  EXPECT_GT(near, 50);
  EXPECT_LT(found.size(), 1500u);
}

// One sphere far away from the others must not ask for cells all the way to it.
TEST(SizeGrids, DoWithFewCellsForFewSpheres) {
  Charge charge;
  charge.add({0, 0, 0}, 0.001);
  charge.add({0.002, 0, 0}, 0.001);
  charge.add({1e5, 1e5, 1e5}, 0.001);
  EXPECT_THAT(found_by(SizeGrids(charge.spheres(), {0.0005}), 0), ElementsAre(1));
}

TEST(SizeGrids, MayBeEmpty) {
  Charge charge;
  charge.add({0, 0, 0}, 1.0);
  EXPECT_THAT(found_by(SizeGrids(charge.spheres(), {1.0}), 0), IsEmpty());
  EXPECT_NO_THROW(SizeGrids(Spheres{nullptr, {}}, {1.0}));
}

}  // namespace
}  // namespace millwear::recorder
