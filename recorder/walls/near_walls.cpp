#include "recorder/walls/near_walls.h"

#include <liggghts/atom.h>
#include <liggghts/fix_mesh_surface.h>
#include <liggghts/fix_neighlist_mesh.h>
#include <liggghts/fix_wall_gran.h>
#include <liggghts/lammps.h>
#include <liggghts/neighbor.h>
#include <liggghts/tri_mesh.h>

#include <cstddef>
#include <typeinfo>
#include <vector>

#include "recorder/liggghts/fix_makers.h"
#include "recorder/liggghts/private_member.h"
#include "recorder/walls/triangle_reach.h"

namespace millwear::recorder {

using LAMMPS_NS::FixMeshSurface;
using LAMMPS_NS::FixNeighlistMesh;
using LAMMPS_NS::FixWallGran;
using LAMMPS_NS::MultiVectorContainer;
using LAMMPS_NS::TriangleNeighlist;
using LAMMPS_NS::TriMesh;
using LAMMPS_NS::VectorContainer;

// What is near a triangle, and its nodes, LIGGGHTS shows by copies or to heirs only.
struct NeighboursOfTriangles {
  using Type = std::vector<TriangleNeighlist> FixNeighlistMesh::*;
  friend Type member(NeighboursOfTriangles);
};
template struct Reach<NeighboursOfTriangles, &FixNeighlistMesh::triangles>;

struct Nodes {
  using Type = MultiVectorContainer<double, 3, 3> LAMMPS_NS::MultiNodeMesh<3>::*;
  friend Type member(Nodes);
};
template struct Reach<Nodes, &TriMesh::node_>;

namespace {

class NearWalls : public FixWallGran {
 public:
  using FixWallGran::FixWallGran;

 protected:
  void post_force_mesh(int vflag) override {
    if (!serves()) return FixWallGran::post_force_mesh(vflag);
    near_.resize(static_cast<std::size_t>(n_FixMesh_));
    for (int m = 0; m < n_FixMesh_; ++m) find_near(m);
    exchange_lists();
    FixWallGran::post_force_mesh(vflag);
    exchange_lists();
  }

 private:
  using Neighbours = std::vector<TriangleNeighlist>;

  [[nodiscard]] bool serves() const;
  void find_near(int of_mesh);
  void exchange_lists();
  [[nodiscard]] Neighbours& neighbours(int of_mesh) const {
    return FixMesh_list_[of_mesh]->meshNeighlist()->*member(NeighboursOfTriangles{});
  }

  std::vector<std::vector<std::vector<int>>> near_;  ///< by mesh and triangle
  std::vector<int> room_;
};

/// Not where LIGGGHTS has contacts with more than the triangles themselves.
bool NearWalls::serves() const {
  if (radius_ == nullptr || atom->shapetype_flag || atom->superquadric_flag ||
      neighbor->contactDistanceFactor > 1.0)
    return false;
  for (int m = 0; m < n_FixMesh_; ++m) {
    FixMeshSurface& fix = *FixMesh_list_[m];
    TriMesh& mesh = *fix.triMesh();
    if (typeid(mesh) != typeid(TriMesh) || fix.meshMulticontactData() != nullptr ||
        neighbours(m).size() != static_cast<std::size_t>(mesh.size()))
      return false;
  }
  return true;
}

void NearWalls::find_near(int of_mesh) {
  TriMesh& mesh = *FixMesh_list_[of_mesh]->triMesh();
  const auto& triangles = neighbours(of_mesh);
  auto& near = near_[static_cast<std::size_t>(of_mesh)];
  near.resize(triangles.size());
  // LIGGGHTS keeps the vectors of a container in one piece.
  using Vectors = MultiVectorContainer<double, 3, 3>;
  const double* const nodes = **(mesh.*member(Nodes{})).begin();
  const double* const edges = **mesh.prop().getElementProperty<Vectors>("edgeNorm")->begin();
  const double* const normals =
      *mesh.prop().getElementProperty<VectorContainer<double, 3>>("surfaceNorm")->begin();
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& all = triangles[t].contacts;
    near[t].clear();
    if (all.empty()) continue;
    if (room_.size() < all.size()) room_.resize(2 * all.size());
    const auto count = find_within_reach(planes_of(nodes + 9 * t, normals + 3 * t, edges + 9 * t),
                                         {*atom->x, radius_}, all, room_);
    near[t].assign(room_.begin(), room_.begin() + static_cast<std::ptrdiff_t>(count));
  }
}

void NearWalls::exchange_lists() {
  for (int m = 0; m < n_FixMesh_; ++m) {
    auto& triangles = neighbours(m);
    for (std::size_t t = 0; t < triangles.size(); ++t)
      triangles[t].contacts.swap(near_[static_cast<std::size_t>(m)][t]);
  }
}

LAMMPS_NS::Fix* new_near_walls(LAMMPS_NS::LAMMPS* liggghts, int argument_count, char** arguments) {
  return new NearWalls(liggghts, argument_count, arguments);
}

}  // namespace

void look_only_near_walls(LAMMPS_NS::LAMMPS& liggghts) {
  make_fixes_by(liggghts, "wall/gran", new_near_walls);
}

}  // namespace millwear::recorder
