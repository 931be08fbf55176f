#include "wear/record/charge_position.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "mill/base/failure.h"
#include "mill/liner/mill_frame.h"
#include "wear/numerics/closed_curve.h"

namespace millwear::wear {
namespace {

using std::numbers::pi;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr Eigen::Index smoothing_half_width = 2;
constexpr double level_of_percentile = 0.1;
constexpr double percentile_of_level = 0.9;

struct Arc {
  double toe;
  double shoulder;
};

/// A tenth of the 90th percentile over the degrees that were touched at all.
double charge_level(const Eigen::VectorXd& occupancy) {
  std::vector<double> touched;
  std::copy_if(occupancy.begin(), occupancy.end(), std::back_inserter(touched),
               [](double value) { return value > 0.0; });
  return level_of_percentile *
         percentile(Eigen::Map<Eigen::VectorXd>(touched.data(), std::ssize(touched)),
                    percentile_of_level);
}

double radians(double degrees) { return degrees * pi / 180.0; }

/// Degrees from six o'clock.
std::optional<double> crossing(const Eigen::VectorXd& occupancy, double level, Eigen::Index from,
                               int direction) {
  const auto steps = steps_until_below(occupancy, level, from, direction);
  if (!steps) return std::nullopt;
  const double centre = static_cast<double>(from) + 0.5 - 180.0;
  return centre + direction * *steps;
}

std::optional<Arc> charge_arc(const Eigen::VectorXd& contacts) {
  if (!(contacts.maxCoeff() > 0.0)) return std::nullopt;
  const Eigen::VectorXd occupancy = running_mean(contacts, smoothing_half_width);
  Eigen::Index fullest = 0;
  occupancy.maxCoeff(&fullest);
  const double level = charge_level(occupancy);
  const auto toe = crossing(occupancy, level, fullest, -1);
  const auto shoulder = crossing(occupancy, level, fullest, 1);
  if (!toe || !shoulder) return std::nullopt;
  return Arc{from_three_oclock(radians(*toe)), from_three_oclock(radians(*shoulder))};
}

double standard_error(const std::vector<Arc>& blocks, double Arc::*angle, double whole) {
  if (blocks.size() < 2) return unknown;
  const auto count = static_cast<double>(blocks.size());
  double sum = 0.0;
  double squares = 0.0;
  for (const Arc& block : blocks) {
    const double deviation = std::remainder(block.*angle - whole, 2.0 * pi);
    sum += deviation;
    squares += deviation * deviation;
  }
  return std::sqrt(std::max(0.0, squares - sum * sum / count) / (count * (count - 1.0)));
}

}  // namespace

ChargeAngles no_charge_angles(std::size_t block_count) {
  const auto blocks = static_cast<Eigen::Index>(block_count);
  return {Eigen::MatrixXd::Zero(degrees_around, blocks),
          Eigen::MatrixXd::Zero(degrees_around, blocks)};
}

ChargeAngles with_blocks(const ChargeAngles& angles, std::size_t block_count) {
  ChargeAngles longer = no_charge_angles(block_count);
  longer.contacts.leftCols(angles.contacts.cols()) = angles.contacts;
  longer.normal_force.leftCols(angles.normal_force.cols()) = angles.normal_force;
  return longer;
}

Eigen::Index degree_around(double angle_from_six) {
  return around(static_cast<Eigen::Index>(std::floor((angle_from_six / pi + 1.0) * 180.0)),
                degrees_around);
}

void add_contact(ChargeAngles& angles, double angle_from_six, double normal_force,
                 std::size_t block) {
  const Eigen::Index degree = degree_around(angle_from_six);
  angles.contacts(degree, static_cast<Eigen::Index>(block)) += 1.0;
  angles.normal_force(degree, static_cast<Eigen::Index>(block)) += normal_force;
}

ChargePosition charge_position(const ChargeAngles& angles) {
  const Eigen::VectorXd contacts = angles.contacts.rowwise().sum();
  if (!(contacts.maxCoeff() > 0.0)) {
    throw ResultRejected("nothing touches the liner: no toe and no shoulder can be found");
  }
  const auto whole = charge_arc(contacts);
  if (!whole) return {unknown, unknown, unknown, unknown};
  std::vector<Arc> blocks;
  for (const auto& block : angles.contacts.colwise()) {
    if (const auto arc = charge_arc(block)) blocks.push_back(*arc);
  }
  return {whole->toe, standard_error(blocks, &Arc::toe, whole->toe), whole->shoulder,
          standard_error(blocks, &Arc::shoulder, whole->shoulder)};
}

}  // namespace millwear::wear
