#include "meshgen/stl_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meshgen/liner_mesh.h"
#include "mill/base/failure.h"
#include "mill/liner/mill_frame.h"
#include "tests/support/sample_liners.h"

namespace millwear::meshgen {
namespace {

using test::bytes_of;
using ::testing::HasSubstr;

LinerMesh laboratory_mesh() {
  return build_liner_mesh(test::laboratory_liner(), 0.12, {.tolerance = 0.45e-3});
}

std::string rejection_of(const std::filesystem::path& path) {
  try {
    static_cast<void>(read_stl(path));
  } catch (const ResultRejected& error) {
    return error.what();
  }
  return "";
}

TEST(StlFile, KeepsTheOrderOfTriangles) {
  const test::ScratchFolder folder;
  const LinerMesh mesh = laboratory_mesh();
  write_stl(mesh, folder / "liner.stl");
  const auto facets = read_stl(folder / "liner.stl");
  ASSERT_EQ(facets.size(), mesh.triangles.size());
  const LinerProfile profile = test::laboratory_liner();
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const Eigen::Vector3d centre = (facets[i][0] + facets[i][1] + facets[i][2]) / 3.0;
    EXPECT_EQ(to_master(profile.sector, centre.x(), centre.z(), 0.0).row,
              address_of(mesh, i).lifter);
  }
}

// LIGGGHTS joins triangles by their corners' coordinates: the text of a corner must be one and the
// same in all of them.
TEST(StlFile, NeighboursShareTheirCornersToTheLastDigit) {
  const test::ScratchFolder folder;
  const LinerMesh mesh = laboratory_mesh();
  write_stl(mesh, folder / "liner.stl");
  const auto facets = read_stl(folder / "liner.stl");
  std::vector<std::optional<Eigen::Vector3d>> seen(mesh.vertices.size());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      auto& first = seen[mesh.triangles[i][corner]];
      first = first.value_or(facets[i][corner]);
      EXPECT_EQ(*first, facets[i][corner]);
    }
  }
}

TEST(StlFile, SameMeshGivesTheSameBytes) {
  const test::ScratchFolder folder;
  write_stl(laboratory_mesh(), folder / "a.stl");
  write_stl(laboratory_mesh(), folder / "b.stl");
  EXPECT_EQ(bytes_of(folder / "a.stl"), bytes_of(folder / "b.stl"));
}

TEST(StlFile, LeavesNothingBesideIt) {
  const test::ScratchFolder folder;
  write_stl(laboratory_mesh(), folder / "liner.stl");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(StlFile, RejectsHalfAFile) {
  const test::ScratchFolder folder;
  write_stl(laboratory_mesh(), folder / "liner.stl");
  const auto size = std::filesystem::file_size(folder / "liner.stl");
  std::filesystem::resize_file(folder / "liner.stl", size / 2);
  EXPECT_THAT(rejection_of(folder / "liner.stl"), HasSubstr("incomplete or not ASCII STL"));
}

TEST(StlFile, RejectsAFileWithoutItsEnd) {
  const test::ScratchFolder folder;
  write_stl(laboratory_mesh(), folder / "liner.stl");
  const std::string bytes = bytes_of(folder / "liner.stl");
  std::filesystem::resize_file(folder / "liner.stl", bytes.rfind("endsolid"));
  EXPECT_THAT(rejection_of(folder / "liner.stl"), HasSubstr("facet or endsolid wanted"));
}

TEST(StlFile, SaysWhichFileCannotBeWritten) {
  const test::ScratchFolder folder;
  EXPECT_THROW(write_stl(laboratory_mesh(), folder / "nowhere/liner.stl"), Failure);
  EXPECT_THROW(static_cast<void>(read_stl(folder / "absent.stl")), DiskError);
}

}  // namespace
}  // namespace millwear::meshgen
