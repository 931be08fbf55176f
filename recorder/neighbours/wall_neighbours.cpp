#include "recorder/neighbours/wall_neighbours.h"

#include <liggghts/atom.h>
#include <liggghts/bounding_box.h>
#include <liggghts/fix_neighlist_mesh.h>
#include <liggghts/fix_property_atom.h>
#include <liggghts/tri_mesh.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "recorder/neighbours/particle_neighbours.h"

namespace millwear::recorder {
namespace {

using Eigen::Vector3d;

/// Unit vector along an edge.
Vector3d along(const Vector3d& from, const Vector3d& to) { return (to - from).normalized(); }

/// What LIGGGHTS counts as near a triangle is a prism around it: as far as the reach from its plane
/// and from the line of each edge. So a corner of angle a reaches 1 / sin(a/2) times as far, away
/// from the triangle. How far the prism's box stands out of the triangle's, for a reach of 1.
Place growth_of(const std::array<Vector3d, 3>& corners) {
  Vector3d farthest = Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const Vector3d next = along(corners[k], corners[(k + 1) % 3]);
    const Vector3d last = along(corners[k], corners[(k + 2) % 3]);
    const double sine_of_half = std::sqrt(0.5 * (1.0 - next.dot(last)));
    const Vector3d out = (next + last).normalized() / sine_of_half;
    farthest = farthest.cwiseMax(out.cwiseAbs());
  }
  const Vector3d normal =
      (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized().cwiseAbs();
  return {farthest.x() + normal.x(), farthest.y() + normal.y(), farthest.z() + normal.z()};
}

class WallNeighbours : public LAMMPS_NS::FixNeighlistMesh {
 public:
  using FixNeighlistMesh::FixNeighlistMesh;

  void pre_force(int vflag) override {
    if (!buildNeighList) return;
    const auto* const particles = dynamic_cast<const ParticleNeighbours*>(neighbor);
    const bool serves = mesh_->isMoving() && !globalNumAllContacts_ && particles != nullptr &&
                        particles->grids_of_this_step() != nullptr;
    if (!serves) return FixNeighlistMesh::pre_force(vflag);
    buildNeighList = false;
    build_by_size(*particles);
  }

 private:
  void build_by_size(const ParticleNeighbours& particles);
  void find_near(int triangle, const ParticleNeighbours& particles);

  std::vector<int> candidates_;
  std::vector<std::pair<std::uint64_t, int>> ordered_;
};

void WallNeighbours::build_by_size(const ParticleNeighbours& particles) {
  skin = neighbor->skin;  // particle and wall may each come nearer by half of it
  std::fill_n(fix_nneighs_->vector_atom, atom->nmax, 0.0);
  const int count = mesh_->sizeLocal() + mesh_->sizeGhost();
  if (triangles.size() != static_cast<std::size_t>(count)) initializeNeighlist();
  for (int triangle = 0; triangle < count; ++triangle) find_near(triangle, particles);
  fix_nneighs_->do_forward_comm();
}

void WallNeighbours::find_near(int triangle, const ParticleNeighbours& particles) {
  std::array<Vector3d, 3> corners;
  for (int k = 0; k < 3; ++k) mesh_->node(triangle, k, corners[k].data());
  Place low, high;
  mesh_->getElementBoundingBoxOnSubdomain(triangle).getBoxBounds(low.data(), high.data());
  candidates_.clear();
  particles.grids_of_this_step()->add_spheres_near(low, high, growth_of(corners), candidates_);

  ordered_.clear();
  for (const int i : candidates_) {
    const bool meets_walls = i < atom->nlocal && (atom->mask[i] & groupbit_wall_mesh) != 0;
    if (!meets_walls) continue;
    const double radius = atom->radius[i] * neighbor->contactDistanceFactor;
    if (mesh_->resolveTriSphereNeighbuild(triangle, radius, atom->x[i], skin))
      ordered_.emplace_back(particles.order_by_columns(i), i);
  }
  std::sort(ordered_.begin(), ordered_.end());

  auto& near = triangles[triangle].contacts;
  near.clear();
  for (const auto& [bin, i] : ordered_) {
    near.push_back(i);
    fix_nneighs_->set_vector_atom_int(i, fix_nneighs_->get_vector_atom_int(i) + 1);
  }
}

}  // namespace

LAMMPS_NS::Fix* new_wall_neighbours(LAMMPS_NS::LAMMPS* liggghts, int argument_count,
                                    char** arguments) {
  return new WallNeighbours(liggghts, argument_count, arguments);
}

}  // namespace millwear::recorder
