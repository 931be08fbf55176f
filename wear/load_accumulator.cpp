#include "wear/load_accumulator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mill/failure.h"
#include "mill/mill_frame.h"

namespace millwear::wear {
namespace {

constexpr double beyond_the_end = 1.000001;

const LoadMeasurement& checked(const LoadMeasurement& m) {
  if (m.bins <= 0 || m.class_count == 0 || m.block_count == 0 || !(m.slice_length > 0.0) ||
      !(m.duration > 0.0) || !(m.sample_interval > 0.0) || !(m.contact_limit > 0.0)) {
    throw InputError(
        "a load measurement needs bins, particle classes, time blocks, slice length, duration, "
        "sample interval and contact limit above zero");
  }
  return m;
}

WallLoad empty_load(const LinerSector& sector, const LoadMeasurement& m, double length) {
  WallLoad load{};
  load.slice_length = m.slice_length;
  load.rows = sector.rows;
  load.duration = m.duration;
  load.class_count = m.class_count;
  load.block_count = m.block_count;
  const Eigen::Index cells = Eigen::Index{m.bins} * cells_per_bin;
  load.bin_edges = Eigen::VectorXd::LinSpaced(cells + 1, 0.0, length);
  load.values.fill(
      Eigen::MatrixXd::Zero(cells, static_cast<Eigen::Index>(m.class_count * m.block_count)));
  load.rejected.fill(0.0);
  return load;
}

double share(double rejected, double taken) {
  return rejected + taken > 0.0 ? rejected / (rejected + taken) : 0.0;
}

double share_of(const WallLoad& load, Measure measure) {
  const auto m = static_cast<std::size_t>(measure);
  return share(load.rejected[m], load.values[m].sum());
}

}  // namespace

LoadAccumulator::LoadAccumulator(const LinerProfile& profile, const LoadMeasurement& measurement)
    : sector_(profile.sector),
      measurement_(checked(measurement)),
      index_(profile, measurement.contact_limit),
      cells_per_metre_(measurement.bins * cells_per_bin / index_.length()),
      load_(empty_load(sector_, measurement, index_.length())),
      angles_(no_charge_angles(measurement.block_count)) {}

std::size_t LoadAccumulator::block_of(double time) const {
  const double end = measurement_.duration + beyond_the_end * measurement_.sample_interval;
  if (!(time >= 0.0 && time <= end)) {
    throw ResultRejected(
        fmt::format("a sample at {} s lies outside the measurement of {} s; record from its "
                    "beginning to its end only",
                    time, measurement_.duration));
  }
  const auto blocks = static_cast<double>(measurement_.block_count);
  const auto block = static_cast<std::size_t>(time / measurement_.duration * blocks);
  return std::min(block, measurement_.block_count - 1);
}

void LoadAccumulator::add(const WallContacts& sample) {
  const std::size_t block = block_of(sample.time);
  const double dt = measurement_.sample_interval;
  for (const WallContact& contact : sample.contacts) {
    const std::array<double, measure_count> amounts = {
        1.0, contact.normal_force * dt,
        std::max(contact.normal_force, 0.0) * contact.slip_speed * dt,
        contact.normal_force * contact.normal_speed * dt};
    const double x = contact.point.x();
    const double z = contact.point.z();
    if (contact.particle_class >= measurement_.class_count ||
        !std::isfinite(x + z + amounts[1] + amounts[2] + amounts[3])) {
      throw ResultRejected(fmt::format(
          "a wall contact at {} s is of particle class {} of {} or holds a value that is not "
          "finite",
          sample.time, contact.particle_class, measurement_.class_count));
    }
    add_contact(angles_, angle_from_six_oclock(x, z), contact.normal_force, block);
    const auto master = to_master(sector_, x, z, sample.mill_angle);
    const ProfilePlace place = index_.nearest(master.position);
    if (!(place.distance <= measurement_.contact_limit)) {
      for (std::size_t m = 0; m < measure_count; ++m) load_.rejected[m] += amounts[m];
      continue;
    }
    const Eigen::Index cell =
        std::min(static_cast<Eigen::Index>(place.arc_length * cells_per_metre_), load_.bins() - 1);
    const auto column =
        static_cast<Eigen::Index>(contact.particle_class * measurement_.block_count + block);
    for (std::size_t m = 0; m < measure_count; ++m) load_.values[m](cell, column) += amounts[m];
  }
}

WallLoad coarsened(const WallLoad& load, int factor) {
  if (factor <= 0 || load.bins() % factor != 0) {
    throw InputError(fmt::format("{} bins cannot be joined by {}", load.bins(), factor));
  }
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

WallLoad sum_of(const WallLoad& first, const WallLoad& second) {
  if (first.bin_edges != second.bin_edges || first.class_count != second.class_count ||
      first.block_count != second.block_count || first.rows != second.rows ||
      first.slice_length != second.slice_length || first.duration != second.duration) {
    throw InputError("two wall loads can be summed only on the same bins, classes and blocks");
  }
  WallLoad sum = first;
  for (std::size_t m = 0; m < measure_count; ++m) {
    sum.values[m] += second.values[m];
    sum.rejected[m] += second.rejected[m];
  }
  return sum;
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
