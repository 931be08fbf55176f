#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "meshgen/liner_mesh.h"
#include "mill/case/time_step.h"
#include "mill/liner/mill_frame.h"
#include "orchestrator/campaign/mesh_files.h"
#include "tests/needs_liggghts/mill_trial.h"
#include "wear/record/profile_index.h"

namespace millwear::trial {
namespace {

using liggghts::StretchSteps;

class SmallMill : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!liggghts_is_installed()) GTEST_SKIP() << "liggghts or mpirun is not installed";
  }

  const Case mill_ = small_mill(ContactPath::dumps);
  const StepPlan plan_ = plan_steps(mill_);
  /// Two pitches of mixing; one of settling and one of measuring.
  const StretchSteps mixing_{plan_.time_step, 2 * plan_.steps_per_pitch, 0, 20};
  const StretchSteps measuring_{plan_.time_step, plan_.steps_per_pitch, plan_.steps_per_pitch, 20};
  const ScratchFolder scratch_;
};

/// Section (x, z) of a triangle, its two places with different (x, z).
struct Facet {
  Eigen::Vector2d start, end;
};

Eigen::Vector2d section(const Eigen::Vector3d& place) { return {place.x(), place.z()}; }

Facet facet_of(const meshgen::LinerMesh& mesh, std::size_t triangle) {
  const auto& corners = mesh.triangles.at(triangle);
  Facet facet{section(mesh.vertices[corners[0]]), section(mesh.vertices[corners[1]])};
  const Eigen::Vector2d third = section(mesh.vertices[corners[2]]);
  if ((facet.end - facet.start).norm() < 1e-9) facet.end = third;
  return facet;
}

double distance_to(const Facet& facet, const Eigen::Vector2d& place) {
  const Eigen::Vector2d along = facet.end - facet.start;
  const double t = std::clamp((place - facet.start).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (facet.start + t * along - place).norm();
}

// The triangle that LIGGGHTS names, turned with the mill, is where the contact is; its lifter and
// facet are those that folding the contact into the sector gives; and it lies on the profile.
TEST_F(SmallMill, TriangleAndGeometryAgreeOnWhereAContactIs) {
  mix(mill_, mixing_, scratch_.stage("mix"), 1);
  const Stretch stretch =
      measure(mill_, measuring_, mill_.liner, scratch_.stage("dem"), "mix", 0, 1);
  const auto& sector = mill_.liner.sector;
  const double tolerance = mesh_tolerance(mill_);
  const double overlap = 0.01 * largest_diameter(mill_);
  const wear::ProfileIndex profile(mill_.liner, 0.01);
  std::size_t contacts = 0;
  std::set<int> lifters;
  double farthest_from_facet = 0.0;
  double farthest_from_profile = 0.0;
  join_dumps(mill_, stretch.steps, stretch.dumps, [&](const WallContacts& sample) {
    for (const auto& contact : sample.contacts) {
      ++contacts;
      const auto address = meshgen::address_of(stretch.mesh, contact.triangle);
      const Eigen::Vector2d turned_back =
          Eigen::Rotation2Dd(sample.mill_angle) * section(contact.point);
      farthest_from_facet = std::max(
          farthest_from_facet, distance_to(facet_of(stretch.mesh, contact.triangle), turned_back));
      const auto master =
          to_master(sector, contact.point.x(), contact.point.z(), sample.mill_angle);
      farthest_from_profile =
          std::max(farthest_from_profile, profile.nearest(master.position).distance);
      // On the very edge of a sector the two may name neighbours, for the same place.
      const Eigen::Vector2d named = to_mill(sector, master.position, address.lifter, 0.0);
      if ((named - turned_back).norm() > 1e-6) {
        EXPECT_NEAR(std::abs(angle_of(sector, master.position)), 0.5 * sector.pitch(), 1e-3);
      }
      const auto first_of_facet = static_cast<std::size_t>(
          2 * stretch.mesh.layers *
          (address.lifter * stretch.mesh.facets_per_lifter + address.facet));
      EXPECT_LE(distance_to(facet_of(stretch.mesh, first_of_facet), turned_back),
                tolerance + overlap);
      lifters.insert(address.lifter);
    }
  });
  RecordProperty("contacts", std::to_string(contacts));
  RecordProperty("farthest_from_facet_um", std::to_string(1e6 * farthest_from_facet));
  RecordProperty("farthest_from_profile_um", std::to_string(1e6 * farthest_from_profile));
  EXPECT_GT(contacts, 2000u);
  EXPECT_GE(lifters.size(), 3u);
  EXPECT_LT(farthest_from_facet, 1e-6);
  EXPECT_LT(farthest_from_profile, tolerance + 1e-6);
  for (const auto& line : stretch.log.thermo) EXPECT_EQ(line.atoms, 120u);
}

// The same deck with the same ranks gives the same bytes, and so the same load.
TEST_F(SmallMill, SameDeckGivesTheSameDumps) {
  const StretchSteps steps{plan_.time_step, 500, 1500, 20};
  mix(mill_, mixing_, scratch_.stage("mix"), 1);
  const auto first = measure(mill_, steps, mill_.liner, scratch_.stage("one"), "mix", 0, 2);
  const auto second = measure(mill_, steps, mill_.liner, scratch_.stage("two"), "mix", 0, 2);
  EXPECT_GT(first.dumps.contacts.size(), 10000u);
  EXPECT_TRUE(first.dumps.contacts == second.dumps.contacts);
  EXPECT_TRUE(first.dumps.spins == second.dumps.spins);
  const auto load = load_of(mill_, steps, mill_.liner, first.dumps);
  const auto again = load_of(mill_, steps, mill_.liner, second.dumps);
  for (std::size_t m = 0; m < measure_count; ++m) EXPECT_EQ(load.values[m], again.values[m]);
}

}  // namespace
}  // namespace millwear::trial
