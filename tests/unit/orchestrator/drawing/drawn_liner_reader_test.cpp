#include "orchestrator/drawing/drawn_liner_reader.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "meshgen/drawing/dxf_polyline.h"
#include "mill/base/failure.h"
#include "mill/liner/parametric_lifter.h"
#include "mill/liner/profile_measures.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

using testing::HasSubstr;

constexpr LinerSector sector{4.0, 3.9, 52};
constexpr double degree = std::numbers::pi / 180.0;
/// Leans to one side, so that its mirror image is another.
constexpr ParametricLifter lifter{0.2, 0.1, 20.0 * degree, 5.0 * degree};

class DrawnLinerFile : public testing::Test {
 protected:
  /// A part of the liner's own nodes, turned and moved.
  [[nodiscard]] DrawnLiner drawn(std::span<const Eigen::Vector2d> nodes, double angle,
                                 double shift) const {
    std::vector<Eigen::Vector2d> curve;
    for (const auto& node : nodes)
      curve.emplace_back(Eigen::Rotation2Dd(angle) * node + shift * Eigen::Vector2d(1, -2));
    meshgen::write_dxf_polyline(curve, "LINER", file);
    return {file, {}, {}, {}, false};
  }
  void expect_the_liner(const LinerProfile& read) const {
    EXPECT_NEAR(lifter_height(read), 0.2, 1e-6);
    EXPECT_NEAR(leading_face_angle(read), 20.0 * degree, 1e-6);
    EXPECT_NEAR(plate_thickness(read), plate_thickness(liner), 1e-6);
    EXPECT_NEAR(steel_area(read), steel_area(liner), 1e-6);
  }

  LinerProfile liner = profile_of(sector, lifter);
  TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "liner.dxf";
};

TEST_F(DrawnLinerFile, IsPutOnThePlateFromAnywhere) {
  for (const double angle : {0.0, 0.7, 2.0, 3.14, -1.5})
    expect_the_liner(read_drawn_liner(drawn(liner.nodes, angle, 12.0), sector));
}

TEST_F(DrawnLinerFile, GetsThePlateWhereOnlyTheLifterIsDrawn) {
  const auto is_high = [](const Eigen::Vector2d& node) { return node.y() > 0.1; };
  const auto first_top = std::ranges::find_if(liner.nodes, is_high);
  const auto last_top = std::find_if(liner.nodes.rbegin(), liner.nodes.rend(), is_high).base() - 1;
  const auto read = read_drawn_liner(drawn({first_top - 1, last_top + 2}, 1.0, 3.0), sector);
  EXPECT_NEAR(lifter_height(read), 0.2, 1e-3);
  EXPECT_NEAR(steel_area(read), steel_area(liner), 1e-3 * steel_area(liner));
}

TEST_F(DrawnLinerFile, IsSeenFromTheOtherEndWhereItIsMirrored) {
  DrawnLiner mirror = drawn(liner.nodes, 0.3, 1.0);
  mirror.is_mirrored = true;
  EXPECT_NEAR(leading_face_angle(read_drawn_liner(mirror, sector)), 5.0 * degree, 1e-6);
}

TEST_F(DrawnLinerFile, StandsOnItsOriginWhereThatIsGiven) {
  DrawnLiner placed = drawn(liner.nodes, 0.0, 0.5);
  placed.origin = Eigen::Vector2d(500.0, -1000.0);
  const auto read = read_drawn_liner(placed, sector);
  ASSERT_EQ(read.nodes.size(), liner.nodes.size());
  for (std::size_t i = 0; i < read.nodes.size(); ++i)
    EXPECT_LT((read.nodes[i] - liner.nodes[i]).norm(), 1e-9);
}

TEST_F(DrawnLinerFile, OfAnotherSizeAsksForTheUnit) {
  DrawnLiner wrong = drawn(liner.nodes, 0.0, 0.0);
  wrong.unit = LengthUnit::inch;
  try {
    static_cast<void>(read_drawn_liner(wrong, sector));
    FAIL() << "it was taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.string() + ": the curve's ends are"));
    EXPECT_THAT(error.what(), HasSubstr("say the drawing's unit with `profile_unit`"));
  }
}

}  // namespace
}  // namespace millwear::orchestrator
