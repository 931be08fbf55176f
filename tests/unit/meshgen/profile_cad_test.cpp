#include "meshgen/profile_cad.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "meshgen/drawing/drawing_profile.h"
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
  const auto drawn = drawing_profile(folder / "profile.dxf", "LINER");
  EXPECT_EQ(drawn.unit, LengthUnit::millimetre);
  ASSERT_EQ(drawn.nodes.size(), profile.nodes.size());
  for (std::size_t i = 0; i < drawn.nodes.size(); ++i) {
    EXPECT_NEAR((1e-3 * drawn.nodes[i] - profile.nodes[i]).norm(), 0.0, 1e-12);
  }
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
