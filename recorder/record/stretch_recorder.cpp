#include "recorder/record/stretch_recorder.h"

#include <fmt/format.h>
#include <liggghts/atom.h>
#include <liggghts/comm.h>
#include <liggghts/lammps.h>
#include <liggghts/neighbor.h>
#include <liggghts/tri_mesh.h>
#include <liggghts/update.h>

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/liner/profile_csv.h"
#include "mill/liner/profile_measures.h"
#include "mill/load/contact_motion.h"
#include "mill/recording/recorder_lines.h"
#include "recorder/liggghts/atom_values.h"
#include "recorder/pairs/pair_contacts.h"
#include "recorder/record/mesh_hook.h"
#include "recorder/record/rank_exchange.h"
#include "wear/record/load_write.h"

namespace millwear::recorder {
namespace {

using Eigen::Vector3d;
using LAMMPS_NS::LAMMPS;

constexpr std::size_t most_waiting = 12;

/// Before the first run deals the mesh out to the ranks, each rank holds all of it.
std::size_t triangles_of(LAMMPS_NS::FixMeshSurface& mesh) {
  auto& triangles = *mesh.triMesh();
  return static_cast<std::size_t>(std::max(triangles.sizeGlobal(), triangles.sizeLocal()));
}

LoadMeasurement measurement_of(const Case& mill, const RecordingPlan& plan, double time_step,
                               std::size_t triangles) {
  auto measurement = load_measurement(mill, time_step * static_cast<double>(steps_of_blocks(plan)),
                                      time_step * static_cast<double>(plan.every_steps), triangles);
  measurement.motion = MotionRecord::kept;
  return measurement;
}

void check_particles(const LAMMPS& liggghts, const Case& mill) {
  const auto& atom = *liggghts.atom;
  const auto wanted = static_cast<std::int64_t>(totals(mill).particles);
  if (atom.natoms != wanted)
    throw InputError(
        fmt::format("the deck has {} particles and the case {}; give the case that "
                    "the deck was written for",
                    atom.natoms, wanted));
  if (atom.map_style == 0)
    throw InputError(
        "the recorder follows particles by number: the deck needs "
        "`atom_modify map array`");
}

void check_blocks(const Case& mill, const RecordingPlan& plan) {
  if (!plan.going_on) return;
  const long measured = plan.last_step - plan.first_step;
  if (plan.going_on->by_steps * mill.wear.time_blocks % measured != 0)
    throw InputError(
        fmt::format("--go-on-by {} makes no whole time blocks where {} steps are {}; a multiple of "
                    "{} does",
                    plan.going_on->by_steps, measured, mill.wear.time_blocks,
                    measured / std::gcd(measured, long{mill.wear.time_blocks})));
}

}  // namespace

StretchRecorder::StretchRecorder(LAMMPS& liggghts, const Case& mill, const RecordingPlan& plan)
    : StretchRecorder(liggghts, mill, plan, {mill.liner.sector, read_profile_nodes(plan.liner)}) {}

StretchRecorder::StretchRecorder(LAMMPS& liggghts, const Case& mill, const RecordingPlan& plan,
                                 const LinerProfile& liner)
    : liggghts_(liggghts),
      mill_(mill),
      plan_(plan),
      liner_(liner),
      mesh_(the_mesh(liggghts)),
      liner_friction_(liner_friction(mill)),
      load_(liner, measurement_of(mill, plan, liggghts.update->dt, triangles_of(mesh_)),
            [this](const wear::Collision& collision) {
              if (spool_) spool_->add(collision);
            }),
      turning_{mill.speed, mill.liner.sector.plate_radius, crest_radius(liner)},
      census_steps_(census_steps(mill, plan, liggghts.update->dt)),
      module_(
          liggghts, mesh_,
          [this](long step) {
            return step == plan_.first_step || is_sampled(plan_, step) ||
                   (pairs_ && step > *plan_.pairs_after && step <= plan_.last_step);
          },
          [this](long step, const std::vector<WallTouch>& touches) { take_step(step, touches); },
          [this](long step, const WallTouch& touch) { take_standing(step, touch); }),
      waiting_(most_waiting),
      wanted_samples_(samples_between(plan, plan.first_step, plan.last_step)),
      sampled_until_(plan.first_step),
      class_of_number_(totals(mill).particles + 1, 0) {
  check_particles(liggghts, mill);
  if (plan.charge)
    charge_.emplace(liggghts, mill, plan, [this](int i) { return class_of_particle(i); });
  if (plan.events) spool_.emplace(*plan.events, liggghts.comm->me);
  check_blocks(mill, plan);
  if (const long whole = measured_until(plan, plan.last_step); whole > steps_of_blocks(plan))
    load_.go_on_until(liggghts.update->dt * static_cast<double>(whole));
  hang_on(liggghts, mesh_, module_);
}

void StretchRecorder::before_run() {
  standing_.contacts.clear();
  // A run sets up by building the neighbour lists at the step where the last one ended.
  latest_step_ = liggghts_.update->ntimestep - 1;
  if (!plan_.pairs_after || pairs_ || liggghts_.update->ntimestep != *plan_.pairs_after) return;
  keep_pair_forces(liggghts_);
  const double dt = liggghts_.update->dt;
  pairs_.emplace(mill_.charge.classes.size(),
                 dt * static_cast<double>(plan_.last_step - *plan_.pairs_after), dt);
}

std::size_t StretchRecorder::class_of_particle(int particle) const {
  const auto& atom = *liggghts_.atom;
  const auto number = static_cast<std::size_t>(atom.tag[particle]);
  if (number >= class_of_number_.size())
    throw ResultRejected(fmt::format("a particle {} that the charge does not have", number));
  std::uint16_t& known = class_of_number_[number];
  if (known == 0) {
    const auto material = static_cast<std::size_t>(atom.type[particle]) - 1;
    const auto found = class_of(mill_.charge.classes, material, 2.0 * atom.radius[particle]);
    if (!found)
      throw ResultRejected(
          fmt::format("a particle of radius {} m and atom type {} is of no class of the charge",
                      atom.radius[particle], atom.type[particle]));
    known = static_cast<std::uint16_t>(*found + 1);
  }
  return static_cast<std::size_t>(known) - 1;
}

WallContact StretchRecorder::contact_from(const WallTouch& touch, Company company) const {
  const auto& atom = *liggghts_.atom;
  const int i = touch.particle;
  const ContactMotion motion =
      contact_motion(touch.arm, atom.radius[i], at(atom.v, i) - touch.wall, at(atom.omega, i));
  const double pushed = -touch.force.dot(motion.into_wall);
  const Vector3d tangential = touch.force + pushed * motion.into_wall;
  const std::size_t kind = class_of_particle(i);
  return {.point = at(atom.x, i) + touch.arm,
          .into_wall = motion.into_wall,
          .normal_force = pushed,
          .slip_speed = sliding_speed(motion, tangential, pushed, liner_friction_[kind]),
          .path_speed = path_speed(motion, tangential, pushed, liner_friction_[kind]),
          .normal_speed = motion.normal_speed,
          .impact_speed = touch.approach.norm(),
          .impact_normal_speed = touch.approach.dot(motion.into_wall),
          .shear_power = -tangential.dot(motion.slip),
          .finnie_power =
              finnie_power(touch.approach, touch.arm, touch.wall_normal, touch.force.norm()),
          .particle_class = kind,
          .particle = static_cast<std::size_t>(atom.tag[i]),
          .triangle = static_cast<std::size_t>(touch.triangle),
          .company = company};
}

void StretchRecorder::check_that_it_turns(const WallTouch& touch) const {
  constexpr double tolerance = 1e-3;
  const Vector3d point = at(liggghts_.atom->x, touch.particle) + touch.arm;
  const Vector3d expected(mill_.speed * point.z(), 0.0, -mill_.speed * point.x());
  if ((touch.wall - expected).norm() > tolerance * expected.norm() + 1e-9)
    throw InputError(fmt::format(
        "the deck's mesh moves at {:.4g} m/s where the case's speed makes {:.4g}; give the case "
        "that the deck was written for",
        touch.wall.norm(), expected.norm()));
}

double StretchRecorder::time_at(long step) const {
  return liggghts_.update->dt * static_cast<double>(measured_until(plan_, step));
}

bool StretchRecorder::left_this_rank(std::uint32_t particle) const {
  const int i = liggghts_.atom->map(static_cast<int>(particle));
  return i < 0 || i >= liggghts_.atom->nlocal;
}

void StretchRecorder::exchange_collisions(long step) {
  // Particles change ranks only where neighbour lists are built.
  const bool could_move = liggghts_.neighbor->lastcall > latest_step_;
  latest_step_ = step;
  if (!could_move || liggghts_.comm->nprocs == 1) return;
  sum_waiting();
  const auto left = [this](std::uint32_t particle) { return left_this_rank(particle); };
  for (const auto& open : of_all_ranks(load_.collisions().release(left), liggghts_.world))
    if (!left_this_rank(open.so_far.particle)) load_.collisions().adopt(open);
  if (!pairs_) return;
  for (const auto& open : of_all_ranks(pairs_->release(left), liggghts_.world))
    if (!left_this_rank(open.first)) pairs_->adopt(open);
}

void StretchRecorder::take_step(long step, const std::vector<WallTouch>& touches) {
  if (!begun_ && step > plan_.first_step) begin_with_standing();
  exchange_collisions(step);
  if (plan_.pairs_after && !pairs_ && !pair_record_ && step > *plan_.pairs_after)
    throw InputError(fmt::format("--pairs-after {}: no `run` of the deck begins at that step",
                                 *plan_.pairs_after));
  if (pairs_ && step > *plan_.pairs_after) take_pairs();
  if (step != plan_.first_step && !is_sampled(plan_, step)) return;
  const double dt = liggghts_.update->dt;
  WallContacts& sample = waiting_[waiting_count_];
  sample.time = time_at(step);
  sample.mill_angle = mill_.speed * dt * static_cast<double>(step);
  sample.interval = dt * static_cast<double>(step - sampled_until_);
  sampled_until_ = step;
  sample.contacts.clear();
  const auto& company = company_.of(liggghts_, touches);
  for (std::size_t i = 0; i < touches.size(); ++i)
    sample.contacts.push_back(contact_from(touches[i], company[i]));
  if (!seen_turning_ && !touches.empty()) check_that_it_turns(touches.front());
  seen_turning_ = seen_turning_ || !touches.empty();
  if (step == plan_.first_step) {
    begun_ = true;
    return load_.begin_with(sample);
  }
  // Both are multiples of the samples' interval, the first step need not be.
  if ((step - plan_.first_step % plan_.every_steps) % census_steps_ == 0) take_census(sample.time);
  if (charge_) charge_->take_frame(step);
  ++samples_;
  if (++waiting_count_ == waiting_.size()) sum_waiting();
}

void StretchRecorder::take_census(double time) {
  load_.add_census(time, census_of(liggghts_, turning_));
  if (charge_) charge_->take_census();
}

void StretchRecorder::sum_waiting() {
  for (std::size_t i = 0; i < waiting_count_; ++i) load_.add(waiting_[i]);
  waiting_count_ = 0;
}

void StretchRecorder::take_standing(long step, const WallTouch& touch) {
  if (begun_ || step != plan_.first_step) return;
  standing_.time = time_at(step);
  standing_.mill_angle = mill_.speed * liggghts_.update->dt * static_cast<double>(step);
  standing_.contacts.push_back(contact_from(touch, Company::unknown));
}

/// A run that begins with the measurement has no step before it whose contacts could be seen.
void StretchRecorder::begin_with_standing() {
  begun_ = true;
  latest_step_ = plan_.first_step;
  load_.begin_with(standing_);
}

void StretchRecorder::take_pairs() {
  pairs_->begin_sample();
  for_each_pair(liggghts_, [this](const PairTouch& touch) {
    const auto& tag = liggghts_.atom->tag;
    pairs_->add({.first = static_cast<std::uint32_t>(tag[touch.first]),
                 .second = static_cast<std::uint32_t>(tag[touch.second]),
                 .first_class = static_cast<std::uint32_t>(class_of_particle(touch.first)),
                 .second_class = static_cast<std::uint32_t>(class_of_particle(touch.second)),
                 .normal_power = touch.normal_power,
                 .shear_power = touch.shear_power,
                 .rolling_power = touch.rolling_power});
    if (charge_) charge_->add(touch);
  });
  pairs_->end_sample();
  if (charge_) charge_->end_step_of_pairs();
}

void StretchRecorder::finish_pairs() {
  if (!pairs_) return;
  pair_record_ = pairs_->finish();
  pairs_.reset();
}

NextPiece StretchRecorder::decide() {
  const WallLoad load = sum_over_ranks(load_.load_so_far(), liggghts_.world);
  NextPiece next{};
  if (liggghts_.comm->me == 0) {
    next = next_piece(mill_, plan_, liner_, load);
    fmt::print("{}\n", printed(line_for_log(plan_, next)));
    std::fflush(stdout);
  }
  MPI_Bcast(&next, sizeof next, MPI_BYTE, 0, liggghts_.world);
  return next;
}

long StretchRecorder::steps_to_go_on() {
  if (!plan_.going_on || liggghts_.update->ntimestep != plan_.last_step || ended_) return 0;
  sum_waiting();
  finish_pairs();
  const NextPiece next = decide();
  goal_ = next.goal;
  ended_ = next.steps == 0;
  if (ended_) return 0;
  wanted_samples_ += samples_between(plan_, plan_.last_step, plan_.last_step + next.steps);
  plan_.last_step += next.steps;
  load_.go_on_until(time_at(plan_.last_step));
  return next.steps;
}

void StretchRecorder::publish() {
  if (samples_ != wanted_samples_)
    throw ResultRejected(
        fmt::format("the deck ended at step {} and gave {} samples of the wall contacts, not {}; "
                    "its runs and --after, --until, --every do not fit",
                    liggghts_.update->ntimestep, samples_, wanted_samples_));
  if (plan_.going_on && !ended_)
    throw InputError(
        fmt::format("--until {}: no `run` of the deck ends at that step, where it is "
                    "to be decided whether the measurement goes on",
                    plan_.last_step));
  sum_waiting();
  finish_pairs();
  auto mine = load_.finish();
  mine.pairs = pair_record_;
  mine.goal = goal_;
  if (spool_) spool_->close();
  if (charge_) charge_->publish(*plan_.charge);
  const auto record = sum_over_ranks(std::move(mine), liggghts_.world);
  if (liggghts_.comm->me != 0) return;
  if (plan_.events) publish_collisions(*plan_.events, liggghts_.comm->nprocs);
  publish_written(plan_.load,
                  [&](const std::filesystem::path& beside) { wear::write_record(beside, record); });
}

}  // namespace millwear::recorder
