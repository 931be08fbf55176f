#include "recorder/turning/turning_mesh.h"

#include <liggghts/fix_move_mesh.h>
#include <liggghts/lammps.h>
#include <liggghts/mesh_mover.h>
#include <liggghts/mesh_mover_rotation.h>
#include <liggghts/tri_mesh.h>
#include <liggghts/update.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <typeinfo>

#include "recorder/liggghts/fix_makers.h"
#include "recorder/liggghts/private_member.h"
#include "recorder/turning/turned_vectors.h"

namespace millwear::recorder {

using LAMMPS_NS::AssociativePointerArray;
using LAMMPS_NS::ContainerBase;
using LAMMPS_NS::CustomValueTracker;
using LAMMPS_NS::FixMoveMesh;
using LAMMPS_NS::GeneralContainer;
using LAMMPS_NS::MeshMover;
using LAMMPS_NS::MeshMoverRotate;
using LAMMPS_NS::MultiNodeMesh;
using LAMMPS_NS::MultiVectorContainer;
using LAMMPS_NS::TriMesh;
using LAMMPS_NS::VectorContainer;

// What LIGGGHTS's own rotation of a mesh reads and writes.
struct Mover {
  using Type = MeshMover* FixMoveMesh::*;
  friend Type member(Mover);
};
struct MovedTime {
  using Type = double FixMoveMesh::*;
  friend Type member(MovedTime);
};
struct MovedTimeSinceSetup {
  using Type = double FixMoveMesh::*;
  friend Type member(MovedTimeSinceSetup);
};
struct Axis {
  using Type = double (MeshMoverRotate::*)[3];
  friend Type member(Axis);
};
struct AngularSpeed {
  using Type = double MeshMoverRotate::*;
  friend Type member(AngularSpeed);
};
struct Centres {
  using Type = VectorContainer<double, 3> MultiNodeMesh<3>::*;
  friend Type member(Centres);
};
struct GlobalProperties {
  using Type = AssociativePointerArray<ContainerBase> CustomValueTracker::*;
  friend Type member(GlobalProperties);
};
struct ReferenceFrame {
  using Type = int ContainerBase::*;
  friend Type member(ReferenceFrame);
};
template struct Reach<Mover, &FixMoveMesh::move_>;
template struct Reach<MovedTime, &FixMoveMesh::time_>;
template struct Reach<MovedTimeSinceSetup, &FixMoveMesh::time_since_setup_>;
template struct Reach<Axis, &MeshMoverRotate::axis_>;
template struct Reach<AngularSpeed, &MeshMoverRotate::omega_>;
template struct Reach<Centres, &TriMesh::center_>;
template struct Reach<GlobalProperties, &CustomValueTracker::globalProperties_>;
template struct Reach<ReferenceFrame, &ContainerBase::refFrame_>;

namespace {

constexpr std::size_t corners = 3;

/// LIGGGHTS keeps the vectors of a container in one piece.
template <int vectors>
std::span<double> values_of(GeneralContainer<double, vectors, 3>& container, int elements) {
  if (elements == 0) return {};
  return {**container.begin(), static_cast<std::size_t>(elements) * vectors * 3};
}

/// As `MultiNodeMesh::rotate` makes it.
Quaternion quaternion_of(double angle, const double* axis) {
  Triple along;
  LAMMPS_NS::vectorCopy3D(axis, along.data());
  LAMMPS_NS::vectorScalarDiv3D(along.data(), LAMMPS_NS::vectorMag3D(along.data()));
  const double sine = std::sin(angle * 0.5);
  return {std::cos(angle * 0.5), along[0] * sine, along[1] * sine, along[2] * sine};
}

bool is_turned_alone(ContainerBase& property) {
  const int frame = property.*member(ReferenceFrame{});
  return frame == LAMMPS_NS::REF_FRAME_SCALE_TRANS_INVARIANT ||
         frame == LAMMPS_NS::REF_FRAME_TRANS_INVARIANT;
}

class TurningMesh : public FixMoveMesh {
 public:
  using FixMoveMesh::FixMoveMesh;

  void initial_integrate(int vflag) override {
    auto* const mover = dynamic_cast<MeshMoverRotate*>(this->*member(Mover{}));
    auto* const mesh = dynamic_cast<TriMesh*>(this->mesh());
    if (mover == nullptr || mesh == nullptr || !serves(*mover, *mesh))
      return FixMoveMesh::initial_integrate(vflag);
    this->*member(MovedTime{}) += update->dt;
    this->*member(MovedTimeSinceSetup{}) += update->dt;
    turn(*mover, *mesh);
  }

 private:
  static bool serves(MeshMoverRotate& mover, TriMesh& mesh);
  void turn(MeshMoverRotate& mover, TriMesh& mesh);
  static void turn_properties(CustomValueTracker& properties, const Turn& turn);
};

MultiVectorContainer<double, 3, 3>* velocities_of(TriMesh& mesh) {
  return mesh.prop().getElementProperty<MultiVectorContainer<double, 3, 3>>("v");
}

bool TurningMesh::serves(MeshMoverRotate& mover, TriMesh& mesh) {
  if (typeid(mover) != typeid(MeshMoverRotate) || typeid(mesh) != typeid(TriMesh)) return false;
  if (!mover.isFirst() || mesh.nMove() != 1 || mesh.is_set_store_omega()) return false;
  const auto* const velocities = velocities_of(mesh);
  return velocities != nullptr && velocities->size() == mesh.size();
}

void TurningMesh::turn(MeshMoverRotate& mover, TriMesh& mesh) {
  const double speed = mover.*member(AngularSpeed{});
  const double* const axis = mover.*member(Axis{});
  const double angle = speed * update->dt;
  Turn turn{quaternion_of(angle, axis), {}};
  mover.get_reference_point(turn.centre.data());
  TurningSpeed turning{{}, turn.centre};
  LAMMPS_NS::vectorScalarMult3D(axis, speed, turning.spin.data());

  const int triangles = mesh.size();
  auto& centres = mesh.*member(Centres{});
  if (triangles > 0) {
    const std::span nodes(**mover.get_nodes(), corners * 3 * static_cast<std::size_t>(triangles));
    turn_points(nodes, turn);
    find_centres(nodes, values_of(centres, triangles));
    find_velocities(nodes, turning, values_of(*velocities_of(mesh), triangles));
  }
  mesh.updateGlobalBoundingBox();
  turn_properties(mesh.prop(), turn);
  rotate(angle, axis, turn.centre.data());
}

/// What LIGGGHTS keeps of each triangle, and of the mesh, that a turn changes.
void TurningMesh::turn_properties(CustomValueTracker& properties, const Turn& turn) {
  const Triple& centre = turn.centre;
  const Triple back{-centre[0], -centre[1], -centre[2]};
  const bool displaced = LAMMPS_NS::vectorMag3DSquared(centre.data()) > 0.0;
  for (int i = 0; i < properties.nElementProperties(); ++i) {
    ContainerBase& property = *properties.getElementPropertyBase(i);
    if (is_turned_alone(property)) {
      if (auto* const three = dynamic_cast<GeneralContainer<double, 3, 3>*>(&property)) {
        turn_directions(values_of(*three, three->size()), turn.quaternion);
        continue;
      }
      if (auto* const one = dynamic_cast<GeneralContainer<double, 1, 3>*>(&property)) {
        turn_directions(values_of(*one, one->size()), turn.quaternion);
        continue;
      }
    }
    if (displaced) property.move(back.data());
    property.rotate(turn.quaternion.data());
    if (displaced) property.move(centre.data());
  }
  auto& of_mesh = properties.*member(GlobalProperties{});
  if (displaced) of_mesh.move(back.data());
  of_mesh.rotate(turn.quaternion.data());
  if (displaced) of_mesh.move(centre.data());
}

LAMMPS_NS::Fix* new_turning_mesh(LAMMPS_NS::LAMMPS* liggghts, int argument_count,
                                 char** arguments) {
  return new TurningMesh(liggghts, argument_count, arguments);
}

}  // namespace

void turn_meshes_by_vectors(LAMMPS_NS::LAMMPS& liggghts) {
  make_fixes_by(liggghts, "move/mesh", new_turning_mesh);
}

}  // namespace millwear::recorder
