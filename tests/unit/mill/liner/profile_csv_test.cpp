#include "mill/liner/profile_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "mill/base/failure.h"
#include "mill/liner/parametric_lifter.h"
#include "mill/liner/profile_crossing.h"
#include "mill/liner/profile_ends.h"

namespace millwear {
namespace {

constexpr LinerSector sector{0.52, 0.5, 12};

class ProfileCsv : public testing::Test {
 protected:
  void SetUp() override {
    path_ = std::filesystem::temp_directory_path() /
            ("millwear_profile_" + std::to_string(getpid()) + ".csv");
  }
  void TearDown() override { std::filesystem::remove(path_); }

  std::vector<Eigen::Vector2d> nodes(const std::string& text) {
    std::ofstream(path_) << text;
    return read_profile_nodes(path_);
  }
  std::string refusal(const std::string& text) {
    try {
      static_cast<void>(nodes(text));
    } catch (const InputError& error) {
      return std::string(error.what()).substr(path_.string().size());
    }
    return "";
  }

  std::filesystem::path path_;
};

TEST_F(ProfileCsv, FindsColumnsByName) {
  const auto read =
      nodes("# gauge\n note , eta_m ,xi_m\n\n1, 0.5 ,-0.25 # first\r\n2,1e-3,0\n3,0,0.1");
  ASSERT_EQ(read.size(), 3U);
  EXPECT_EQ(read[0], Eigen::Vector2d(-0.25, 0.5));
  EXPECT_EQ(read[1], Eigen::Vector2d(0.0, 1e-3));
}

TEST_F(ProfileCsv, NamesTheLineOfAnError) {
  EXPECT_THAT(refusal("xi_m,eta_m\n0,0\n0.1,zero\n"),
              testing::StartsWith(":3: `zero` is not a number"));
  EXPECT_THAT(refusal("xi_m,eta_m\n0,0.1 m\n"), testing::StartsWith(":2: `0.1 m` is not a number"));
  EXPECT_THAT(refusal("xi_m,eta_m\n0,nan\n"), testing::StartsWith(":2: `nan` is not a number"));
  EXPECT_THAT(refusal("xi_m,eta_m\n0.1\n"), testing::StartsWith(":2: 1 values where"));
  EXPECT_THAT(refusal("x,y\n0,0\n"), testing::StartsWith(":1: no column `xi_m`"));
  EXPECT_THAT(refusal(""), testing::StartsWith(":1: the table is empty"));
}

TEST_F(ProfileCsv, TakesAPointThatIsRepeatedOnce) {
  std::ofstream(path_) << "xi_m,eta_m\n-0.06,0.003613\n-0.02,0.04\n-0.02,0.04\n0.02,0.04\n"
                          "0.06,0.003613\n";
  const LinerProfile read = read_profile_csv(path_, sector);
  EXPECT_EQ(std::ranges::count(read.nodes, Eigen::Vector2d(-0.02, 0.04)), 1);
}

TEST_F(ProfileCsv, MissingFileIsNamed) {
  EXPECT_THROW(static_cast<void>(read_profile_nodes("no_such_profile.csv")), InputError);
}

/// The nodes of a lifter from foot to foot, without the plate.
std::vector<Eigen::Vector2d> bare_lifter() {
  const LinerProfile whole = profile_of(sector, {0.04, 0.05, 0.3, 0.2}, PlateShape::straight);
  return {whole.nodes.begin() + 1, whole.nodes.end() - 1};
}

// A lifter alone gets the plate's arc: the same as the parametric profile.
TEST(CompletedProfile, LifterAloneGetsItsPlate) {
  const LinerProfile expected = profile_of(sector, {0.04, 0.05, 0.3, 0.2});
  const LinerProfile completed = completed_profile(sector, bare_lifter());
  ASSERT_EQ(completed.nodes.size(), expected.nodes.size());
  for (std::size_t i = 0; i < expected.nodes.size(); ++i) {
    EXPECT_LT((completed.nodes[i] - expected.nodes[i]).norm(), 1e-12) << i;
  }
}

TEST(CompletedProfile, WholePitchStaysToTheBit) {
  const LinerProfile whole = profile_of(sector, {0.04, 0.05, 0.3, 0.2}, PlateShape::straight);
  EXPECT_EQ(completed_profile(sector, whole.nodes).nodes, whole.nodes);
}

// Ends once put on the sector edges are not moved again by a rounding error.
RC_GTEST_PROP(CompletedProfile, IsCompletedOnce, ()) {
  auto nodes = bare_lifter();
  const double radius = 0.46 + *rc::gen::inRange(0, 40000) * 1e-6;
  nodes.insert(nodes.begin(), point_at(sector, radius, -0.5 * sector.pitch() + 1e-4));
  nodes.push_back(point_at(sector, radius + 3e-4, 0.5 * sector.pitch()));
  const LinerProfile once = completed_profile(sector, nodes);
  RC_ASSERT(completed_profile(sector, once.nodes).nodes == once.nodes);
}

TEST(CompletedProfile, EndsWithinAMillimetreMeet) {
  auto nodes = profile_of(sector, {0.04, 0.05, 0.3, 0.2}).nodes;
  nodes.front().y() += 0.0008;
  const LinerProfile snapped = completed_profile(sector, nodes);
  EXPECT_NEAR(radius_of(sector, snapped.nodes.front()), radius_of(sector, snapped.nodes.back()),
              1e-15);
  nodes.front().y() += 0.0008;
  EXPECT_THROW(static_cast<void>(completed_profile(sector, nodes)), InputError);
}

// To nine decimals the edges at 15 degrees of R = 0.5 m are (+-0.129409523, 0.017037087): such ends
// lie some 1e-10 m off the edges and from each other, and are made one point.
TEST(CompletedProfile, EndsOfNineDecimalsAreOnePoint) {
  auto nodes = bare_lifter();
  nodes.insert(nodes.begin(), {-0.129409523, 0.017037087});
  nodes.push_back({0.129409523, 0.017037087});
  const LinerProfile snapped = completed_profile(sector, nodes);
  const Eigen::Vector2d carried = shifted_by_pitches(sector, snapped.nodes.front(), 1);
  EXPECT_LT((carried - snapped.nodes.back()).norm(), 1e-15);
  EXPECT_NE(snapped.nodes.front(), nodes.front());
}

// A gauge that read past the edge and took a point on it: the cut comes there, and only once.
TEST(CompletedProfile, CutsOnceAtANodeOnTheEdge) {
  auto nodes = bare_lifter();
  nodes.insert(nodes.begin(), point_at(sector, 0.5, -0.5 * sector.pitch()));
  nodes.insert(nodes.begin(), point_at(sector, 0.5, -0.35));
  const LinerProfile cut = completed_profile(sector, nodes);
  EXPECT_GT((cut.nodes[1] - cut.nodes[0]).norm(), 1e-3);
  EXPECT_EQ(first_crossing(cut), (std::pair(-1, -1)));
}

// A gauge that read 40 degrees of the mill: what lies beyond the 30 of the sector is cut.
TEST(CompletedProfile, CutsBeyondTheSector) {
  auto nodes = bare_lifter();
  nodes.insert(nodes.begin(), point_at(sector, 0.5, -0.35));
  nodes.push_back(point_at(sector, 0.5, 0.35));
  const LinerProfile cut = completed_profile(sector, nodes);
  EXPECT_NEAR(angle_of(sector, cut.nodes.front()), -0.5 * sector.pitch(), 1e-12);
  EXPECT_NEAR(angle_of(sector, cut.nodes.back()), 0.5 * sector.pitch(), 1e-12);
  EXPECT_EQ(cut.nodes.size(), nodes.size());
}

TEST(CompletedProfile, RefusesLooseEndsAndBackwardNodes) {
  auto loose = bare_lifter();
  loose.front().y() += 0.005;
  EXPECT_THROW(static_cast<void>(completed_profile(sector, loose)), InputError);
  auto backwards = bare_lifter();
  std::reverse(backwards.begin(), backwards.end());
  EXPECT_THROW(static_cast<void>(completed_profile(sector, backwards)), InputError);
  EXPECT_THROW(static_cast<void>(completed_profile(sector, {{0.0, 0.0}, {0.1, 0.0}})), InputError);
}

}  // namespace
}  // namespace millwear
