#include "recorder/record/wall_module.h"

#include <liggghts/atom.h>
#include <liggghts/update.h>

#include <utility>

namespace millwear::recorder {
namespace {

int no_argument = 0;

Eigen::Vector3d vector_of(const double* values) { return {values[0], values[1], values[2]}; }

}  // namespace

WallModule::WallModule(LAMMPS_NS::LAMMPS& liggghts, LAMMPS_NS::FixMeshSurface& fix,
                       std::function<bool(long)> wants,
                       std::function<void(long, const std::vector<WallTouch>&)> take,
                       std::function<void(long, const WallTouch&)> take_standing)
    : MeshModule(&liggghts, no_argument, 0, nullptr, &fix),
      wants_(std::move(wants)),
      take_(std::move(take)),
      take_standing_(std::move(take_standing)) {}

void WallModule::look_at_step() {
  if (update->ntimestep == step_) return;
  step_ = update->ntimestep;
  wanted_ = wants_(step_);
  touches_.clear();
}

Eigen::Vector3d WallModule::normal_of(int triangle) const {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  mesh->surfaceNorm(triangle, normal.data());
  return normal;
}

void WallModule::add_particle_contribution(int particle, double* on_particle, double* arm,
                                           int triangle, double* wall_velocity) {
  // A run sets up by computing the forces of the step before once more.
  const bool standing = update->setupflag != 0;
  if (!standing) look_at_step();
  if (!standing && !wanted_) return;
  const Eigen::Vector3d wall = vector_of(wall_velocity);
  const WallTouch touch{particle,
                        mesh->id(triangle),
                        vector_of(arm),
                        vector_of(on_particle),
                        wall,
                        vector_of(atom->v[particle]) - wall,
                        normal_of(triangle)};
  if (standing)
    take_standing_(update->ntimestep, touch);
  else
    touches_.push_back(touch);
}

void WallModule::end_of_step() {
  look_at_step();
  if (wanted_) take_(step_, touches_);
  step_ = -1;
}

}  // namespace millwear::recorder
