#include "wear/record/charge_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mill/liner/profile_measures.h"

namespace millwear::wear {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr Estimate unknown_estimate{unknown, unknown};
constexpr Eigen::Index falling_degrees = degrees_around / 2;

double& part(Census& census, ChargePart which) { return census[static_cast<Eigen::Index>(which)]; }

Eigen::VectorXd by_block(const ChargeMotion& motion, ChargePart which) {
  return motion.census.row(static_cast<Eigen::Index>(which)).transpose();
}

Eigen::VectorXd sum_around(const Eigen::MatrixXd& by_degree) {
  return by_degree.colwise().sum().transpose();
}

/// Sum of `parts` over the sum of `wholes`, by block. With r that ratio, its error is that of the
/// mean of (part - r whole) over the mean whole.
Estimate ratio(const Eigen::VectorXd& parts, const Eigen::VectorXd& wholes) {
  const double whole = wholes.sum();
  if (!(whole > 0.0)) return unknown_estimate;
  const double value = parts.sum() / whole;
  const auto blocks = static_cast<double>(parts.size());
  if (parts.size() < 2) return {value, unknown};
  const double squares = (parts - value * wholes).squaredNorm();
  return {value, std::sqrt(squares * blocks / (blocks - 1.0)) / whole};
}

BareHits no_hits(Eigen::Index blocks) {
  return {Eigen::MatrixXd::Zero(degrees_around, blocks),
          Eigen::MatrixXd::Zero(degrees_around, blocks)};
}

void add_hits(BareHits& sum, const BareHits& more) {
  const auto had = more.mass.cols();
  sum.mass.leftCols(had) += more.mass;
  sum.energy.leftCols(had) += more.energy;
}

}  // namespace

void count(Census& census, const TurningMill& mill, const ParticleMotion& particle) {
  const double mass = particle.mass;
  part(census, ChargePart::all) += mass;
  if (particle.flight == Flight::airborne) {
    part(census, ChargePart::airborne) += mass;
    return;
  }
  const auto& place = particle.place;
  const Eigen::Vector3d carried(mill.speed * place.z(), 0.0, -mill.speed * place.x());
  if (!(particle.velocity.dot(carried) > 0.0)) return;
  const bool is_locked =
      (particle.velocity - carried).norm() < locked_slip * mill.speed * mill.plate_radius;
  const bool is_between = std::hypot(place.x(), place.z()) > mill.crest_radius;
  part(census, ChargePart::ascending) += mass;
  if (is_locked) part(census, ChargePart::locked) += mass;
  if (is_between) part(census, ChargePart::between) += mass;
  if (is_locked && is_between) part(census, ChargePart::between_locked) += mass;
}

ChargeMotion no_charge_motion(std::size_t block_count) {
  const auto blocks = static_cast<Eigen::Index>(block_count);
  return {Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(charge_part_count), blocks),
          no_hits(blocks), no_hits(blocks)};
}

ChargeMotion with_blocks(const ChargeMotion& motion, std::size_t block_count) {
  ChargeMotion longer = no_charge_motion(block_count);
  add_motion(longer, motion);
  return longer;
}

void add_hit(BareHits& hits, double angle_from_six, double mass, double energy, std::size_t block) {
  const Eigen::Index degree = degree_around(angle_from_six);
  hits.mass(degree, static_cast<Eigen::Index>(block)) += mass;
  hits.energy(degree, static_cast<Eigen::Index>(block)) += energy;
}

void add_motion(ChargeMotion& sum, const ChargeMotion& more) {
  sum.census.leftCols(more.census.cols()) += more.census;
  add_hits(sum.plate, more.plate);
  add_hits(sum.lifter, more.lifter);
}

double plate_limit_radius(const LinerProfile& profile, double tolerance) {
  double lowest = 0.0;
  for (const auto& node : profile.nodes) lowest = std::max(lowest, radius_of(profile.sector, node));
  const double lift = lowest - crest_radius(profile);
  return lift > tolerance ? lowest - std::max(plate_share_of_lift * lift, tolerance) : 0.0;
}

MotionMeasures unknown_motion() {
  return {unknown_estimate, unknown_estimate, unknown_estimate, unknown_estimate,
          unknown_estimate, unknown_estimate, unknown_estimate, unknown_estimate};
}

MotionMeasures motion_measures(const ChargeMotion& motion, const MotionScale& scale) {
  const Eigen::Index blocks = motion.census.cols();
  const Eigen::VectorXd ascending = by_block(motion, ChargePart::ascending);
  const Eigen::VectorXd between_locked = by_block(motion, ChargePart::between_locked);
  const Eigen::VectorXd seconds =
      Eigen::VectorXd::Constant(blocks, scale.duration / static_cast<double>(blocks));
  const Eigen::VectorXd turned = seconds * scale.speed / (2.0 * std::numbers::pi);
  const Eigen::MatrixXd energy = motion.plate.energy + motion.lifter.energy;
  return {.airborne_share =
              ratio(by_block(motion, ChargePart::airborne), by_block(motion, ChargePart::all)),
          .dead_zone_share = ratio(by_block(motion, ChargePart::locked), ascending),
          .between_locked_share = ratio(between_locked, by_block(motion, ChargePart::between)),
          .packed_share = ratio(between_locked, ascending),
          .bare_hit_mass_share =
              ratio(sum_around(motion.plate.mass + motion.lifter.mass), turned * scale.charge_mass),
          .bare_hit_power = ratio(sum_around(energy), seconds),
          .bare_hit_falling_power = ratio(sum_around(energy.topRows(falling_degrees)), seconds),
          .bare_hit_plate_power = ratio(sum_around(motion.plate.energy), seconds)};
}

}  // namespace millwear::wear
