#include "liggghts_inputs/outputs/contact_join.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "mill/base/failure.h"
#include "mill/load/contact_motion.h"

namespace millwear::liggghts {
namespace {

/// The dumps' tangential force is from before friction cut it.
Eigen::Vector3d cut_to(double most, const Eigen::Vector3d& force) {
  const double norm = force.norm();
  return norm > most ? Eigen::Vector3d(force * (most / norm)) : force;
}

}  // namespace

DumpFrame dump_frame(const StretchSteps& steps) {
  return {.time_step = steps.time_step,
          .first_step = steps.settle_steps,
          .last_step = steps.total(),
          .samples = steps.samples()};
}

ContactJoin::ContactJoin(const Case& mill, const StretchSteps& steps, Take take, Take begin)
    : ContactJoin(mill, totals(mill).particles, dump_frame(steps), std::move(take),
                  std::move(begin)) {}

ContactJoin::ContactJoin(const Case& mill, std::size_t particles, const DumpFrame& frame, Take take,
                         Take begin)
    : classes_(mill.charge.classes),
      friction_(liner_friction(mill)),
      slice_length_(mill.slice_length),
      mill_speed_(mill.speed),
      frame_(frame),
      take_(std::move(take)),
      begin_(std::move(begin)),
      row_of_particle_(particles + 1, 0),
      last_step_(frame.first_step) {}

void ContactJoin::take_contacts(const Snapshot& contacts) {
  waiting_contacts_.emplace(contacts.step, contacts);
  join_ready();
}

void ContactJoin::take_spins(const Snapshot& spins) {
  waiting_spins_.emplace(spins.step, spins);
  join_ready();
}

void ContactJoin::finish() const {
  if (!waiting_contacts_.empty() || !waiting_spins_.empty())
    throw ResultRejected(
        fmt::format("the dumps of wall contacts and spins do not hold the same steps (step {})",
                    waiting_contacts_.empty() ? waiting_spins_.begin()->first
                                              : waiting_contacts_.begin()->first));
  if (!begun_)
    throw ResultRejected(fmt::format(
        "the dumps do not hold step {}, with which the measurement begins; without it collisions "
        "that go on would count as new",
        frame_.first_step));
  if (samples_ != frame_.samples || last_step_ != frame_.last_step)
    throw ResultRejected(
        fmt::format("the dumps hold {} samples of the wall contacts, up to step {}, and not {}, up "
                    "to step {}",
                    samples_, last_step_, frame_.samples, frame_.last_step));
}

void ContactJoin::join_ready() {
  while (!waiting_contacts_.empty() && !waiting_spins_.empty()) {
    const auto contacts = waiting_contacts_.begin();
    const auto spins = waiting_spins_.begin();
    if (contacts->first != spins->first) return finish();
    join(contacts->second, spins->second);
    waiting_contacts_.erase(contacts);
    waiting_spins_.erase(spins);
  }
}

void ContactJoin::join(const Snapshot& contacts, const Snapshot& spins) {
  const bool at_start = contacts.step == frame_.first_step;
  const long since = std::exchange(last_step_, contacts.step);
  begun_ = begun_ || at_start;
  if (at_start && !begin_) return;
  index_spins(spins);
  joined_.time = frame_.time_step * static_cast<double>(contacts.step - frame_.first_step);
  joined_.mill_angle = frame_.angle + mill_speed_ * frame_.time_step *
                                          static_cast<double>(contacts.step - frame_.angle_step);
  joined_.interval = frame_.time_step * static_cast<double>(contacts.step - since);
  joined_.contacts.clear();
  for (std::size_t i = 0; i < contacts.rows(); ++i)
    joined_.contacts.push_back(contact_from(contacts.row(i), contacts.step));
  if (at_start) return begin_(joined_);
  ++samples_;
  take_(joined_);
}

bool ContactJoin::is_id(double id) const {
  return id >= 1.0 && id < static_cast<double>(row_of_particle_.size());
}

void ContactJoin::index_spins(const Snapshot& spins) {
  std::fill(row_of_particle_.begin(), row_of_particle_.end(), 0);
  states_.clear();
  for (std::size_t i = 0; i < spins.rows(); ++i) {
    const auto row = spins.row(i);
    if (!is_id(row[0]))
      throw ResultRejected(fmt::format("a particle {} that the charge does not have, at step {}",
                                       row[0], spins.step));
    row_of_particle_[static_cast<std::size_t>(row[0])] = static_cast<std::uint32_t>(i + 1);
    states_.push_back({class_of_particle(static_cast<std::size_t>(row[1]) - 1, row[2]), row[2],
                       vector_at(row, 3), vector_at(row, 6), vector_at(row, 9)});
  }
}

std::size_t ContactJoin::class_of_particle(std::size_t material, double radius) const {
  if (const auto found = class_of(classes_, material, 2.0 * radius)) return *found;
  throw ResultRejected(
      fmt::format("a particle of radius {} m and atom type {} is of no class of the charge", radius,
                  material + 1));
}

const ContactJoin::ParticleState& ContactJoin::state_of(double id, long step) const {
  const std::uint32_t row = is_id(id) ? row_of_particle_[static_cast<std::size_t>(id)] : 0;
  if (row == 0)
    throw ResultRejected(fmt::format(
        "particle {} touches the wall at step {} but is not in the dump of spins", id, step));
  return states_[row - 1];
}

Eigen::Vector3d ContactJoin::vector_at(std::span<const double> row, std::size_t column) const {
  return frame_.to_mill * Eigen::Vector3d(row[column], row[column + 1], row[column + 2]);
}

/// A contact lies on its sphere, less the overlap; else the dumps are of two runs.
void ContactJoin::check_arm(const Eigen::Vector3d& arm, double id, double radius, long step) const {
  constexpr double shortest = 0.5;
  constexpr double longest = 1.02;
  const double length = arm.norm();
  if (length > shortest * radius && length < longest * radius) return;
  throw ResultRejected(
      fmt::format("at step {} the wall contact of particle {} lies {:.4g} m from its centre, and "
                  "its radius is {:.4g} m; the dumps of wall contacts and particles are not of "
                  "one run, or have too few digits",
                  step, id, length, radius));
}

WallContact ContactJoin::contact_from(std::span<const double> row, long step) const {
  const auto& particle = state_of(row[4], step);
  const Eigen::Vector3d point = vector_at(row, 0);
  Eigen::Vector3d arm = point - particle.centre;
  arm.y() -= slice_length_ * std::round(arm.y() / slice_length_);
  check_arm(arm, row[4], particle.radius, step);
  const Eigen::Vector3d wall_velocity(mill_speed_ * point.z(), 0.0, -mill_speed_ * point.x());
  const Eigen::Vector3d velocity = particle.velocity - wall_velocity;
  const ContactMotion motion = contact_motion(arm, particle.radius, velocity, particle.spin);
  const double force = -vector_at(row, 5).dot(motion.into_wall);
  const LinerFriction& friction = friction_[particle.particle_class];
  const Eigen::Vector3d tangential =
      cut_to(friction.coefficient * std::abs(force), vector_at(row, 8));
  return {.point = point,
          .into_wall = motion.into_wall,
          .normal_force = force,
          .slip_speed = sliding_speed(motion, tangential, force, friction),
          .path_speed = path_speed(motion, tangential, force, friction),
          .normal_speed = motion.normal_speed,
          .impact_speed = motion.impact_speed,
          .impact_normal_speed = motion.normal_speed,
          .shear_power = -tangential.dot(motion.slip),
          .finnie_power = finnie_power(velocity, arm, motion.into_wall, std::abs(force)),
          .particle_class = particle.particle_class,
          .particle = static_cast<std::size_t>(row[4]),
          .triangle = static_cast<std::size_t>(row[3])};
}

}  // namespace millwear::liggghts
