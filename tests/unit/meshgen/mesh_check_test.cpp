#include "meshgen/mesh_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "meshgen/facet_outline.h"
#include "mill/base/failure.h"
#include "tests/support/sample_liners.h"

namespace millwear::meshgen {
namespace {

using test::degree;
using ::testing::HasSubstr;

constexpr double slice = 0.12;
const MeshSettings settings{.tolerance = 0.45e-3};

LinerMesh laboratory_mesh() { return build_liner_mesh(test::laboratory_liner(), slice, settings); }

std::string rejection_after(const std::function<void(LinerMesh&)>& spoil) {
  LinerMesh mesh = laboratory_mesh();
  spoil(mesh);
  try {
    static_cast<void>(check_mesh(mesh, test::laboratory_liner(), settings));
  } catch (const ResultRejected& error) {
    return error.what();
  }
  return "";
}

TEST(CheckMesh, MeasuresASoundMesh) {
  const auto profile = test::laboratory_liner();
  const LinerMesh mesh = laboratory_mesh();
  const MeshReport report = check_mesh(mesh, profile, settings);
  EXPECT_EQ(report.triangles,
            static_cast<std::size_t>(12 * mesh.facets_per_lifter * mesh.layers * 2));
  double outline_length = 0.0;
  for (const double length : facet_lengths(dem_outline(profile, settings.tolerance))) {
    outline_length += length;
  }
  EXPECT_NEAR(report.area, 12 * outline_length * slice, 1e-12);
  EXPECT_GE(report.smallest_angle, 0.6 * degree);
  EXPECT_GT(report.largest_deviation, 0.1e-3);
  EXPECT_LE(report.largest_deviation, settings.tolerance);
}

TEST(CheckMesh, AcceptsTheProductionMill) {
  const auto profile = test::production_liner();
  const MeshSettings coarse{.tolerance = 0.03 * 0.011};
  const LinerMesh mesh = build_liner_mesh(profile, 0.25, coarse);
  EXPECT_NO_THROW(static_cast<void>(check_mesh(mesh, profile, coarse)));
}

TEST(CheckMesh, RejectsAHole) {
  EXPECT_THAT(rejection_after([](LinerMesh& mesh) { mesh.triangles.pop_back(); }),
              HasSubstr("liner mesh: "));
  EXPECT_THAT(rejection_after([](LinerMesh& mesh) {
                mesh.triangles.erase(mesh.triangles.begin() + 4, mesh.triangles.begin() + 6);
              }),
              HasSubstr("it has a hole"));
}

TEST(CheckMesh, RejectsATriangleTurnedRound) {
  EXPECT_THAT(
      rejection_after([](LinerMesh& m) { std::swap(m.triangles[7][0], m.triangles[7][1]); }),
      HasSubstr("run the same edge in the same sense"));
}

TEST(CheckMesh, RejectsAMeshTurnedInsideOut) {
  EXPECT_THAT(rejection_after([](LinerMesh& mesh) {
                for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
              }),
              HasSubstr("normals look into the steel"));
}

TEST(CheckMesh, RejectsARimShortOfTheSlice) {
  EXPECT_THAT(rejection_after([](LinerMesh& mesh) {
                for (Eigen::Vector3d& vertex : mesh.vertices) vertex.y() *= 1.0 - 1e-9;
              }),
              HasSubstr("it has a hole"));
}

TEST(CheckMesh, RejectsRimsThatDoNotMatch) {
  EXPECT_THAT(rejection_after([](LinerMesh& mesh) {
                for (Eigen::Vector3d& vertex : mesh.vertices) {
                  vertex.z() += vertex.y() == slice ? 1e-7 : 0.0;
                }
              }),
              HasSubstr("not the same line"));
}

TEST(CheckMesh, RejectsASliver) {
  EXPECT_THAT(rejection_after([](LinerMesh& mesh) {
                const Triangle& t = mesh.triangles[0];
                const Eigen::Vector3d near_corner = mesh.vertices[t[0]];
                for (Eigen::Vector3d& vertex : mesh.vertices) {
                  if (vertex == mesh.vertices[t[1]] || vertex == mesh.vertices[t[2]]) {
                    vertex = near_corner + 1e-3 * (vertex - near_corner);
                    break;
                  }
                }
              }),
              HasSubstr("degrees; the limit is 0.6"));
}

TEST(CheckMesh, RejectsAMeshOffItsProfile) {
  EXPECT_THAT(rejection_after([](LinerMesh& mesh) {
                for (Eigen::Vector3d& vertex : mesh.vertices) vertex.z() -= 1e-3;
              }),
              HasSubstr("m from the profile; the tolerance is 0.00045 m"));
}

std::string rejection_against(const LinerProfile& meshed, const LinerProfile& wanted) {
  const MeshSettings fine{.tolerance = 1e-3};
  const LinerMesh mesh = build_liner_mesh(meshed, 0.01, fine);
  try {
    static_cast<void>(check_mesh(mesh, wanted, fine));
  } catch (const ResultRejected& error) {
    return error.what();
  }
  return "";
}

// A fin of 10 mm, away from the ends and the middle of its facet, that only one of the two has.
TEST(CheckMesh, RejectsAFinTooManyAndAFinTooFew) {
  const LinerProfile plate = test::bare_plate(1.0, 12, 6);
  LinerProfile finned = plate;
  const Eigen::Vector2d start = plate.nodes[0];
  const Eigen::Vector2d facet = plate.nodes[1] - start;
  finned.nodes.insert(finned.nodes.begin() + 1,
                      {start + 0.24 * facet, start + 0.25 * facet + Eigen::Vector2d(0.0, 0.010),
                       start + 0.26 * facet});
  EXPECT_THAT(rejection_against(plate, finned), HasSubstr("m from the profile"));
  EXPECT_THAT(rejection_against(finned, plate), HasSubstr("m from the profile"));
}

// The same shape with its lifters numbered from another one is off the profile by a whole pitch.
TEST(CheckMesh, RejectsTrianglesOutOfOrder) {
  EXPECT_THAT(rejection_after([](LinerMesh& mesh) {
                std::rotate(mesh.triangles.begin(),
                            mesh.triangles.begin() + 2 * mesh.facets_per_lifter * mesh.layers,
                            mesh.triangles.end());
              }),
              HasSubstr("m from the profile"));
}

}  // namespace
}  // namespace millwear::meshgen
