#include "wear/record/load_accumulator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "mill/base/contract.h"
#include "mill/base/failure.h"
#include "mill/liner/mill_frame.h"

namespace millwear::wear {
namespace {

constexpr double beyond_the_end = 1.000001;
/// Share of a block: a time this little before its end lies in the next, whatever the rounding.
constexpr double block_rounding = 1e-9;

const LoadMeasurement& checked(const LoadMeasurement& m) {
  if (m.bins <= 0 || m.class_mass.empty() || m.block_count == 0 || m.particles == 0 ||
      !(m.slice_length > 0.0) || !(m.duration > 0.0) || !(m.sample_interval > 0.0) ||
      !(m.contact_limit > 0.0) || !(m.excess_speed >= 0.0)) {
    throw InputError(
        "a load measurement needs bins, particles and their classes, time blocks, slice length, "
        "duration, sample interval and contact limit above zero");
  }
  return m;
}

WallLoad empty_load(const LinerSector& sector, const LoadMeasurement& m, double length) {
  WallLoad load{};
  load.slice_length = m.slice_length;
  load.rows = sector.rows;
  load.duration = m.duration;
  load.class_count = m.class_mass.size();
  load.block_count = m.block_count;
  const Eigen::Index cells = Eigen::Index{m.bins} * cells_per_bin;
  load.bin_edges = Eigen::VectorXd::LinSpaced(cells + 1, 0.0, length);
  load.values.fill(
      Eigen::MatrixXd::Zero(cells, static_cast<Eigen::Index>(load.class_count * m.block_count)));
  load.rejected.fill(0.0);
  return load;
}

LinerRecord empty_record(const LinerSector& sector, const LoadMeasurement& m, double length) {
  return {empty_load(sector, m, length),
          no_charge_angles(m.block_count),
          empty_spectrum(static_cast<Eigen::Index>(m.class_mass.size())),
          Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(measure_count),
                                static_cast<Eigen::Index>(m.triangles)),
          std::nullopt,
          std::nullopt,
          std::nullopt,
          no_polar_load(m.bins)};
}

double share(double rejected, double taken) {
  return rejected + taken > 0.0 ? rejected / (rejected + taken) : 0.0;
}

double share_of(const WallLoad& load, Measure measure) {
  const auto m = static_cast<std::size_t>(measure);
  return share(load.rejected[m], load.values[m].sum());
}

}  // namespace

LoadAccumulator::LoadAccumulator(const LinerProfile& profile, const LoadMeasurement& measurement,
                                 CollisionTracker::Take ended)
    : sector_(profile.sector),
      measurement_(checked(measurement)),
      block_duration_(measurement.duration / static_cast<double>(measurement.block_count)),
      index_(profile, measurement.contact_limit),
      cells_per_metre_(measurement.bins * cells_per_bin / index_.length()),
      record_(empty_record(sector_, measurement, index_.length())),
      ended_(std::move(ended)),
      tracker_(measurement.particles, measurement.sample_interval,
               [this](const Collision& collision) { take_ended(collision); }),
      plate_limit_(plate_limit_radius(profile, measurement.contact_limit)) {
  block_sums_.setZero(static_cast<Eigen::Index>(measure_count),
                      record_.load.bins() * static_cast<Eigen::Index>(record_.load.class_count));
  if (measurement.motion == MotionRecord::kept)
    record_.motion = no_charge_motion(measurement.block_count);
}

std::size_t LoadAccumulator::block_of(double time, double interval) const {
  const double end = measurement_.duration + beyond_the_end * measurement_.sample_interval;
  if (!(time >= 0.0 && time <= end)) {
    throw ResultRejected(
        fmt::format("a sample at {} s lies outside the measurement of {} s; record from its "
                    "beginning to its end only",
                    time, measurement_.duration));
  }
  const double middle = std::max(time - 0.5 * interval, 0.0);
  const auto block = static_cast<std::size_t>(middle / block_duration_ + block_rounding);
  return std::min(block, measurement_.block_count - 1);
}

LoadAccumulator::Place LoadAccumulator::place_of(const WallContact& contact,
                                                 double mill_angle) const {
  const double x = contact.point.x();
  const double z = contact.point.z();
  const double angle = angle_from_six_oclock(x, z);
  const auto master = to_master_from_polar(sector_, std::sqrt(x * x + z * z), angle, mill_angle);
  return {index_.nearest(master.position), master.row, angle};
}

LinerPlace LoadAccumulator::liner_place(const Place& place) const {
  const bool on_it = place.on_profile.distance <= measurement_.contact_limit;
  return {on_it ? place.on_profile.arc_length : -1.0, place.row};
}

void LoadAccumulator::check(const WallContact& contact, double time) const {
  if (contact.particle_class >= measurement_.class_mass.size() ||
      !std::isfinite(contact.point.sum() + contact.into_wall.sum() + contact.normal_force +
                     contact.slip_speed + contact.path_speed + contact.normal_speed +
                     contact.impact_speed + contact.impact_normal_speed + contact.shear_power +
                     contact.finnie_power)) {
    throw ResultRejected(fmt::format(
        "a wall contact at {} s is of particle class {} of {} or holds a value that is not "
        "finite",
        time, contact.particle_class, measurement_.class_mass.size()));
  }
}

const std::vector<bool>& LoadAccumulator::follow(const WallContacts& sample,
                                                 CollisionTracker::SampleKind kind) {
  places_.clear();
  liner_places_.clear();
  for (const WallContact& contact : sample.contacts) {
    check(contact, sample.time);
    places_.push_back(place_of(contact, sample.mill_angle));
    liner_places_.push_back(liner_place(places_.back()));
  }
  return tracker_.add(sample.time, kind, sample.contacts, liner_places_, sample.interval);
}

void LoadAccumulator::begin_with(const WallContacts& sample) {
  follow(sample, CollisionTracker::SampleKind::before);
}

void LoadAccumulator::add(const WallContacts& sample) {
  const double dt = sample.interval.value_or(measurement_.sample_interval);
  const std::size_t block = block_of(sample.time, dt);
  if (block != block_) close_block();
  block_ = block;
  const auto& begun = follow(sample, CollisionTracker::SampleKind::measured);
  if (record_.motion) add_bare_hits(sample, block);
  for (std::size_t i = 0; i < sample.contacts.size(); ++i) {
    const WallContact& contact = sample.contacts[i];
    const Place& place = places_[i];
    add_contact(record_.angles, place.angle_from_six, contact.normal_force, block);
    const double begins = begun[i] ? 1.0 : 0.0;
    const double half_mass = 0.5 * begins * measurement_.class_mass[contact.particle_class];
    const double excess = std::max(contact.impact_speed - measurement_.excess_speed, 0.0);
    const double pushed = std::max(contact.normal_force, 0.0);
    Amounts amounts;
    amounts << 1.0, begins, contact.normal_force * dt, pushed * contact.slip_speed * dt,
        pushed * contact.path_speed * dt, contact.normal_force * contact.normal_speed * dt,
        contact.shear_power * dt, half_mass * contact.impact_speed * contact.impact_speed,
        half_mass * excess * excess, contact.finnie_power * dt;
    if (contact.triangle < measurement_.triangles)
      record_.triangles.col(static_cast<Eigen::Index>(contact.triangle)).array() += amounts;
    if (!(place.on_profile.distance <= measurement_.contact_limit)) {
      for (std::size_t m = 0; m < measure_count; ++m)
        record_.load.rejected[m] += amounts[static_cast<Eigen::Index>(m)];
      continue;
    }
    const Eigen::Index cells = record_.load.bins();
    const Eigen::Index cell = std::min(
        static_cast<Eigen::Index>(place.on_profile.arc_length * cells_per_metre_), cells - 1);
    block_sums_.col(static_cast<Eigen::Index>(contact.particle_class) * cells + cell) += amounts;
    add_polar_amounts(cell / cells_per_bin, polar_column(place.angle_from_six), amounts);
  }
}

void LoadAccumulator::add_polar_amounts(Eigen::Index bin, Eigen::Index column,
                                        const Amounts& amounts) {
  for (std::size_t m = 0; m < polar_measures.size(); ++m)
    record_.polar->values[m](bin, column) +=
        amounts[static_cast<Eigen::Index>(index_of(polar_measures[m]))];
}

void LoadAccumulator::add_census(double time, const Census& census) {
  record_.motion->census.col(
      static_cast<Eigen::Index>(block_of(time, measurement_.sample_interval))) += census.matrix();
}

/// One hit a particle, also where it meets plate and face at once: the one at the greater speed.
void LoadAccumulator::add_bare_hits(const WallContacts& sample, std::size_t block) {
  const auto& contacts = sample.contacts;
  hits_.clear();
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (tracker_.arrives()[i] && contacts[i].company == Company::none &&
        contacts[i].impact_normal_speed > bare_hit_speed)
      hits_.push_back(i);
  std::ranges::sort(hits_, {}, [&](std::size_t i) {
    return std::tuple(contacts[i].particle, -contacts[i].impact_normal_speed, contacts[i].triangle);
  });
  const auto repeated =
      std::ranges::unique(hits_, {}, [&](std::size_t i) { return contacts[i].particle; });
  hits_.erase(repeated.begin(), repeated.end());
  for (const std::size_t i : hits_) {
    const double mass = measurement_.class_mass[contacts[i].particle_class];
    const double radius = std::hypot(contacts[i].point.x(), contacts[i].point.z());
    add_hit(radius > plate_limit_ ? record_.motion->plate : record_.motion->lifter,
            places_[i].angle_from_six, mass,
            0.5 * mass * contacts[i].impact_speed * contacts[i].impact_speed, block);
  }
}

void LoadAccumulator::take_ended(const Collision& collision) {
  const auto group = static_cast<Eigen::Index>(collision.particle_class);
  if (collision.unfinished == Unfinished::none)
    add_collision(record_.spectrum, group, collision.normal_dissipation,
                  collision.shear_dissipation);
  else
    record_.spectrum.unfinished[group] += 1.0;
  if (ended_) ended_(collision);
}

void LoadAccumulator::close_block() {
  WallLoad& load = record_.load;
  const Eigen::Index cells = load.bins();
  for (std::size_t c = 0; c < load.class_count; ++c) {
    const auto column = static_cast<Eigen::Index>(c * load.block_count + block_);
    const auto first = static_cast<Eigen::Index>(c) * cells;
    for (std::size_t m = 0; m < measure_count; ++m)
      load.values[m].col(column) +=
          block_sums_.row(static_cast<Eigen::Index>(m)).segment(first, cells).matrix().transpose();
  }
  block_sums_.setZero();
}

void LoadAccumulator::go_on_until(double duration) {
  const double blocks = std::round(duration / block_duration_);
  if (!(blocks > static_cast<double>(measurement_.block_count)) ||
      std::abs(blocks * block_duration_ - duration) > 1e-6 * block_duration_)
    throw InputError(
        fmt::format("a measurement of {} s in {} blocks cannot go on until {} s; a multiple of {} "
                    "s above it can",
                    measurement_.duration, measurement_.block_count, duration, block_duration_));
  close_block();
  measurement_.block_count = static_cast<std::size_t>(blocks);
  measurement_.duration = duration;
  record_.load = with_blocks(record_.load, measurement_.block_count);
  record_.load.duration = duration;
  record_.angles = with_blocks(record_.angles, measurement_.block_count);
  if (record_.motion) record_.motion = with_blocks(*record_.motion, measurement_.block_count);
}

const WallLoad& LoadAccumulator::load_so_far() {
  close_block();
  return record_.load;
}

LinerRecord LoadAccumulator::finish() {
  close_block();
  tracker_.finish();
  return record_;
}

WallLoad coarsened(const WallLoad& load, int factor) {
  expect(factor > 0 && load.bins() % factor == 0, "bins are joined by a divisor of their number");
  const Eigen::Index bins = load.bins() / factor;
  WallLoad coarse = load;
  coarse.bin_edges = load.bin_edges(Eigen::seqN(0, bins + 1, factor));
  for (std::size_t m = 0; m < measure_count; ++m) {
    coarse.values[m].setZero(bins, load.values[m].cols());
    for (Eigen::Index cell = 0; cell < load.bins(); ++cell) {
      coarse.values[m].row(cell / factor) += load.values[m].row(cell);
    }
  }
  return coarse;
}

double rejected_share(const WallLoad& load) { return share_of(load, Measure::normal_impulse); }

void check_rejected_share(const WallLoad& load, double limit) {
  const double worst = std::max(share_of(load, Measure::samples), rejected_share(load));
  if (worst > limit) {
    throw ResultRejected(fmt::format(
        "{:.2g} % of the wall contacts lie off the liner's profile, more than the {:.2g} "
        "% allowed; the mesh and the profile do not belong together",
        100.0 * worst, 100.0 * limit));
  }
}

}  // namespace millwear::wear
