#include "recorder/record/charge_census.h"

#include <liggghts/atom.h>
#include <liggghts/fix_gravity.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>

#include <algorithm>

#include "mill/base/constants.h"
#include "recorder/liggghts/atom_values.h"

namespace millwear::recorder {
namespace {

using Eigen::Vector3d;
using LAMMPS_NS::LAMMPS;

constexpr double share_of_weight = 1e-6;

/// Zero for a deck without `fix gravity`.
Vector3d gravity_of(const LAMMPS& liggghts) {
  Vector3d gravity = Vector3d::Zero();
  auto* fix = dynamic_cast<LAMMPS_NS::FixGravity*>(liggghts.modify->find_fix_style("gravity", 0));
  if (fix != nullptr) fix->get_gravity(gravity.data());
  return gravity;
}

/// Whether a force is nothing against the weight of the particle.
bool is_nothing(const Vector3d& force, double mass) {
  return force.squaredNorm() <=
         share_of_weight * share_of_weight * standard_gravity * standard_gravity * mass * mass;
}

bool is_fast(const WallTouch& touch) {
  return touch.approach.dot(touch.arm) > wear::bare_hit_speed * touch.arm.norm();
}

}  // namespace

long census_steps(const Case& mill, const RecordingPlan& plan, double time_step) {
  constexpr double censuses_a_pitch = 50.0;
  constexpr double censuses_a_block = 4.0;
  const double pitch = mill.liner.sector.pitch() / (mill.speed * time_step);
  const double block = static_cast<double>(steps_of_blocks(plan)) / mill.wear.time_blocks;
  const double steps = std::min(pitch / censuses_a_pitch, block / censuses_a_block);
  return plan.every_steps *
         std::max(1L, static_cast<long>(steps / static_cast<double>(plan.every_steps)));
}

wear::Census census_of(LAMMPS& liggghts, const wear::TurningMill& mill) {
  const auto& atom = *liggghts.atom;
  const Vector3d gravity = gravity_of(liggghts);
  wear::Census census = wear::Census::Zero();
  for (int i = 0; i < atom.nlocal; ++i) {
    const double mass = atom.rmass[i];
    const Vector3d contacts = at(atom.f, i) - mass * gravity;
    count(census, mill,
          {at(atom.x, i), at(atom.v, i), mass,
           is_nothing(contacts, mass) ? wear::Flight::airborne : wear::Flight::touching});
  }
  return census;
}

void CompanyFinder::find_fast(const std::vector<WallTouch>& touches) {
  for (const WallTouch& touch : touches) {
    if (!is_fast(touch)) continue;
    const auto particle = static_cast<std::size_t>(touch.particle);
    if (particle >= slot_of_particle_.size()) slot_of_particle_.resize(particle + 1, 0);
    if (slot_of_particle_[particle] != 0) continue;
    fast_.push_back(touch.particle);
    slot_of_particle_[particle] = static_cast<std::uint32_t>(fast_.size());
  }
}

const std::vector<Company>& CompanyFinder::of(LAMMPS& liggghts,
                                              const std::vector<WallTouch>& touches) {
  company_.assign(touches.size(), Company::unknown);
  find_fast(touches);
  if (fast_.empty()) return company_;
  const auto slot_of = [&](const WallTouch& touch) {
    const auto particle = static_cast<std::size_t>(touch.particle);
    return particle < slot_of_particle_.size() ? slot_of_particle_[particle] : 0;
  };
  wall_force_.assign(fast_.size(), Vector3d::Zero());
  for (const WallTouch& touch : touches)
    if (const auto slot = slot_of(touch); slot != 0) wall_force_[slot - 1] += touch.force;
  const auto& atom = *liggghts.atom;
  const Vector3d gravity = gravity_of(liggghts);
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const auto slot = slot_of(touches[i]);
    if (slot == 0) continue;
    const int particle = touches[i].particle;
    const double mass = atom.rmass[particle];
    const Vector3d others = at(atom.f, particle) - mass * gravity - wall_force_[slot - 1];
    company_[i] = is_nothing(others, mass) ? Company::none : Company::others;
  }
  for (const int particle : fast_) slot_of_particle_[static_cast<std::size_t>(particle)] = 0;
  fast_.clear();
  return company_;
}

}  // namespace millwear::recorder
