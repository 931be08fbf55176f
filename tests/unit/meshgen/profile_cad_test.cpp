#include "meshgen/profile_cad.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "meshgen/dxf_polyline.h"
#include "meshgen/gmsh_kernel.h"
#include "mill/base/failure.h"
#include "mill/liner/profile_measures.h"
#include "tests/support/sample_liners.h"

namespace millwear::meshgen {
namespace {

using test::bytes_of;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Step, HoldsTheSteelOfOnePitch) {
  const test::ScratchFolder folder;
  for (const auto& profile : {test::laboratory_liner(), test::production_liner()}) {
    write_step(profile, 0.25, folder / "lifter.step");
    const double expected = steel_area(profile) * 0.25;
    EXPECT_NEAR(volume_of_step(folder / "lifter.step"), expected, 1e-6 * expected);
  }
}

// A bare plate of 300 chords is nearly a ring sector: pi (Rs^2 - Rp^2) L / rows.
TEST(Step, BarePlateIsASectorOfARing) {
  const test::ScratchFolder folder;
  write_step(test::bare_plate(1.0, 12, 300), 0.5, folder / "plate.step");
  const double expected = M_PI * (1.05 * 1.05 - 1.0) * 0.5 / 12;
  EXPECT_NEAR(volume_of_step(folder / "plate.step"), expected, 1e-4 * expected);
}

TEST(Step, SameProfileGivesTheSameBytes) {
  const test::ScratchFolder folder;
  write_step(test::laboratory_liner(), 0.12, folder / "a.step");
  const std::string first = bytes_of(folder / "a.step");
  EXPECT_THAT(first, HasSubstr("'1970-01-01T00:00:00'"));
  for (int i = 0; i < 12; ++i) {
    write_step(test::laboratory_liner(), 0.12, folder / "b.step");
    ASSERT_EQ(first, bytes_of(folder / "b.step")) << i;
  }
}

TEST(Step, DoesNotNameTheFolderItWasWrittenIn) {
  const test::ScratchFolder folder;
  write_step(test::laboratory_liner(), 0.12, folder / "a.step");
  EXPECT_THAT(bytes_of(folder / "a.step"), Not(HasSubstr(folder.path().string())));
}

TEST(Dxf, ReadsBackTheSameNodes) {
  const test::ScratchFolder folder;
  const auto profile = test::production_liner();
  write_dxf(profile, folder / "profile.dxf");
  const auto nodes = read_dxf_polyline("LINER", folder / "profile.dxf");
  ASSERT_EQ(nodes.size(), profile.nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    EXPECT_NEAR((nodes[i] - profile.nodes[i]).norm(), 0.0, 1e-12);
  }
  EXPECT_TRUE(read_dxf_polyline("0", folder / "profile.dxf").empty());
}

/// A drawing with one polyline of two lines and, between them, a quarter of a circle about (1, 1)
/// from (1, 0) to (2, 1).
std::string drawing_with_an_arc(const std::string& unit) {
  return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + unit +
         "\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nCREST\n90\n4\n70\n0\n"
         "10\n0.0\n20\n0.0\n10\n1.0\n20\n0.0\n42\n0.41421356237309503\n10\n2.0\n20\n1.0\n"
         "10\n2.0\n20\n3.0\n0\nENDSEC\n0\nEOF\n";
}

TEST(Dxf, CutsArcsIntoChords) {
  const test::ScratchFolder folder;
  std::ofstream(folder / "arc.dxf") << drawing_with_an_arc("4");
  const DxfDrawing drawing = read_dxf_drawing(folder / "arc.dxf");
  ASSERT_EQ(drawing.polylines.size(), 1U);
  EXPECT_EQ(drawing.polylines[0].layer, "CREST");
  EXPECT_FALSE(drawing.polylines[0].closed);
  const auto& nodes = drawing.polylines[0].nodes;
  ASSERT_EQ(nodes.size(), 4U + 89U);
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    EXPECT_NEAR((nodes[i] - Eigen::Vector2d(1.0, 1.0)).norm(), 1.0, 1e-12);
    EXPECT_GE(nodes[i].x(), 1.0 - 1e-12);
    EXPECT_LE(nodes[i].y(), 1.0 + 1e-12);
  }
}

TEST(Dxf, KnowsTheUnitOfADrawing) {
  const test::ScratchFolder folder;
  const auto unit_of = [&](const std::string& unit) {
    std::ofstream(folder / "unit.dxf") << drawing_with_an_arc(unit);
    return read_dxf_drawing(folder / "unit.dxf").metres_per_unit;
  };
  EXPECT_EQ(unit_of("1"), 0.0254);
  EXPECT_EQ(unit_of("4"), 0.001);
  EXPECT_EQ(unit_of("6"), 1.0);
  EXPECT_FALSE(unit_of("0"));
}

TEST(Dxf, SameProfileGivesTheSameBytes) {
  const test::ScratchFolder folder;
  write_dxf(test::laboratory_liner(), folder / "a.dxf");
  write_dxf(test::laboratory_liner(), folder / "b.dxf");
  EXPECT_EQ(bytes_of(folder / "a.dxf"), bytes_of(folder / "b.dxf"));
}

TEST(Dxf, SaysThatAFolderIsMissing) {
  const test::ScratchFolder folder;
  EXPECT_THROW(write_dxf(test::laboratory_liner(), folder / "nowhere/a.dxf"), DiskError);
}

}  // namespace
}  // namespace millwear::meshgen
