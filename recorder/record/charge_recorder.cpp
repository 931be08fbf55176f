#include "recorder/record/charge_recorder.h"

#include <liggghts/atom.h>
#include <liggghts/comm.h>
#include <liggghts/lammps.h>
#include <liggghts/update.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "mill/base/constants.h"
#include "mill/base/published_file.h"
#include "recorder/liggghts/atom_values.h"
#include "recorder/pairs/pair_contacts.h"
#include "recorder/record/rank_exchange.h"

namespace millwear::recorder {
namespace {

using LAMMPS_NS::LAMMPS;
using wear::ChargeFrames;
using wear::FrameRange;

constexpr int grid_cells = 128;
constexpr std::size_t frame_count = 24;
constexpr double frames_duration = 0.2;          // [s]
constexpr std::size_t most_particles = 100'000;  // in a frame
constexpr std::size_t state_values = 9;

wear::SectionGrid section_of(const Case& mill) {
  return {mill.liner.sector.shell_radius, grid_cells};
}

/// Nothing is faster than what falls through the whole mill from the speed of its shell.
double highest_speed(const Case& mill) {
  const double radius = mill.liner.sector.shell_radius;
  return 1.5 * (mill.speed * radius + std::sqrt(4.0 * standard_gravity * radius));
}

/// Steps between two frames: a multiple of the samples' interval.
long frame_steps_of(const RecordingPlan& plan, double time_step) {
  const double wanted = frames_duration / static_cast<double>(frame_count) / time_step;
  const auto samples = static_cast<long>(wanted / static_cast<double>(plan.every_steps));
  return plan.every_steps * std::max(1L, samples);
}

/// Only the first part of a measurement has frames.
std::size_t frames_of(const RecordingPlan& plan, long frame_steps) {
  if (plan.measured_before.value_or(0) > 0) return 0;
  return std::min(frame_count,
                  static_cast<std::size_t>((plan.last_step - plan.first_step) / frame_steps));
}

ChargeFrames no_frames(const Case& mill) {
  const double radius = mill.liner.sector.shell_radius;
  ChargeFrames frames{.across = {-radius, radius},
                      .along = {0.0, mill.slice_length},
                      .speed = {0.0, highest_speed(mill)},
                      .thinning = 1 + (totals(mill).particles - 1) / most_particles};
  for (const auto& kind : mill.charge.classes) frames.class_radius.push_back(kind.diameter / 2.0);
  return frames;
}

}  // namespace

/// A particle of a frame.
struct ChargeRecorder::Row {
  std::uint32_t number;  ///< from 0, of those that are kept
  std::uint16_t place[3];
  std::uint16_t speed;
  std::uint8_t kind;
  float state[state_values];
};

ChargeRecorder::ChargeRecorder(LAMMPS& liggghts, const Case& mill, const RecordingPlan& plan,
                               ClassOfParticle class_of)
    : liggghts_(liggghts),
      class_of_(std::move(class_of)),
      mill_speed_(mill.speed),
      first_step_(plan.first_step),
      frame_steps_(frame_steps_of(plan, liggghts.update->dt)),
      frames_left_(frames_of(plan, frame_steps_)),
      fields_(section_of(mill), mill.slice_length, mill.charge.classes.size()) {
  if (frames_left_ > 0) frames_ = no_frames(mill);
}

void ChargeRecorder::take_census() {
  const auto& atom = *liggghts_.atom;
  fields_.begin_instant();
  for (int i = 0; i < atom.nlocal; ++i)
    fields_.add({at(atom.x, i), at(atom.v, i), atom.radius[i], atom.rmass[i], class_of_(i)});
}

std::vector<ChargeRecorder::Row> ChargeRecorder::rows() const {
  const auto& atom = *liggghts_.atom;
  std::vector<Row> rows;
  for (int i = 0; i < atom.nlocal; ++i) {
    const auto number = static_cast<std::size_t>(atom.tag[i]) - 1;
    if (number % frames_->thinning != 0) continue;
    const Eigen::Vector3d place = at(atom.x, i);
    const Eigen::Vector3d velocity = at(atom.v, i);
    Row row{.number = static_cast<std::uint32_t>(number / frames_->thinning),
            .place = {frames_->across.packed(place.x()), frames_->along.packed(place.y()),
                      frames_->across.packed(place.z())},
            .speed = frames_->speed.packed(velocity.norm()),
            .kind = static_cast<std::uint8_t>(class_of_(i)),
            .state = {}};
    Eigen::Map<Eigen::Matrix<float, state_values, 1>>(row.state) << place.cast<float>(),
        velocity.cast<float>(), at(atom.omega, i).cast<float>();
    rows.push_back(row);
  }
  return rows;
}

void ChargeRecorder::add_frame(const std::vector<Row>& rows, long step) {
  ChargeFrames& frames = *frames_;
  const std::size_t count = rows.size();
  if (frames.times.empty()) {
    frames.classes.resize(count);
    frames.state.resize(state_values * count);
    for (const Row& row : rows) {
      frames.classes[row.number] = row.kind;
      for (std::size_t i = 0; i < state_values; ++i)
        frames.state[i * count + row.number] = row.state[i];
    }
  }
  const double dt = liggghts_.update->dt;
  const std::size_t places = frames.places.size();
  const std::size_t speeds = frames.speeds.size();
  frames.times.push_back(dt * static_cast<double>(step - first_step_));
  frames.mill_angles.push_back(mill_speed_ * dt * static_cast<double>(step));
  frames.places.resize(places + 3 * count);
  frames.speeds.resize(speeds + count);
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < 3; ++i)
      frames.places[places + i * count + row.number] = row.place[i];
    frames.speeds[speeds + row.number] = row.speed;
  }
}

void ChargeRecorder::take_frame(long step) {
  if (frames_left_ == 0 || step == first_step_ || (step - first_step_) % frame_steps_ != 0) return;
  --frames_left_;
  const auto all = of_all_ranks(rows(), liggghts_.world);
  if (liggghts_.comm->me == 0) add_frame(all, step);
}

void ChargeRecorder::add(const PairTouch& touch) {
  const auto& x = liggghts_.atom->x;
  fields_.add_contact(0.5 * (at(x, touch.first) + at(x, touch.second)), touch.normal_power,
                      touch.shear_power, liggghts_.update->dt);
}

void ChargeRecorder::end_step_of_pairs() { fields_.add_pair_time(liggghts_.update->dt); }

void ChargeRecorder::publish(const std::filesystem::path& path) {
  const wear::ChargeFields fields = sum_over_ranks(fields_.fields(), liggghts_.world);
  if (liggghts_.comm->me != 0) return;
  publish_written(path, [&](const std::filesystem::path& beside) {
    wear::write_charge(beside, {fields, frames_});
  });
}

}  // namespace millwear::recorder
