#pragma once
// clang-format off: LIGGGHTS's mesh module needs its fix declared first
#include <liggghts/fix_mesh_surface.h>
#include <liggghts/mesh_module.h>
// clang-format on

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace millwear::recorder {

/// One particle on one triangle in one step, with the force LIGGGHTS applied.
struct WallTouch {
  int particle;                 ///< LIGGGHTS's index of it on this rank, in this step
  int triangle;                 ///< order of the STL file
  Eigen::Vector3d arm;          ///< from the particle's centre to the contact [m]
  Eigen::Vector3d force;        ///< on the particle [N]
  Eigen::Vector3d wall;         ///< velocity of the wall there [m/s]
  Eigen::Vector3d approach;     ///< velocity of the centre against the wall half a step ago [m/s]
  Eigen::Vector3d wall_normal;  ///< of the triangle, either way
};

/// Collects the wall contacts of a step as LIGGGHTS computes them and hands them over at the step's
/// end, when the particles' velocities are those of the same instant as their forces. Changes
/// nothing in LIGGGHTS.
class WallModule : public LAMMPS_NS::MeshModule {
 public:
  /// `wants` tells which steps are to be collected, `take` gets them. `take_standing` gets the
  /// contacts one by one as a run finds them before its first step.
  WallModule(LAMMPS_NS::LAMMPS& liggghts, LAMMPS_NS::FixMeshSurface& fix,
             std::function<bool(long)> wants,
             std::function<void(long, const std::vector<WallTouch>&)> take,
             std::function<void(long, const WallTouch&)> take_standing);

  void add_particle_contribution(int particle, double* on_particle, double* arm, int triangle,
                                 double* wall_velocity) override;
  void end_of_step() override;

 private:
  void look_at_step();
  [[nodiscard]] Eigen::Vector3d normal_of(int triangle) const;

  std::function<bool(long)> wants_;
  std::function<void(long, const std::vector<WallTouch>&)> take_;
  std::function<void(long, const WallTouch&)> take_standing_;
  std::vector<WallTouch> touches_;
  long step_ = -1;
  bool wanted_ = false;
};

}  // namespace millwear::recorder
