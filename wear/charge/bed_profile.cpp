#include "wear/charge/bed_profile.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "wear/numerics/closed_curve.h"

namespace millwear::wear {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Index places = 400;  // on the line, from one side of the mill to the other
constexpr double bulk_percentile = 0.9;
constexpr double share_of_bulk = 0.5;

/// The middle of the bed as an angle from three o'clock along the rotation.
double middle_of_bed(double shoulder, double bulk_toe) {
  const double end = shoulder < bulk_toe ? shoulder + 2.0 * pi : shoulder;
  return 0.5 * (end + bulk_toe);
}

/// Where a straight line between two values is zero, as a share of the way.
double zero_between(double before, double after) { return before / (before - after); }

}  // namespace

BedProfile bed_profile_of(const ChargeFields& fields, double shoulder, double bulk_toe,
                          double radius) {
  const double middle = middle_of_bed(shoulder, bulk_toe);
  const Vector2d down(-std::cos(middle), std::sin(middle));
  const Vector2d up_slope(std::sin(middle), std::cos(middle));
  BedProfile bed{middle - 1.5 * pi,
                 VectorXd::LinSpaced(places + 1, -radius, radius),
                 VectorXd::Constant(places + 1, nan),
                 nan,
                 nan,
                 nan};
  VectorXd solid(places + 1);
  for (Index i = 0; i <= places; ++i) {
    const Vector2d place = bed.depth[i] * down;
    solid[i] = interpolated(fields, FieldSum::solid, place);
    const double mass = interpolated(fields, FieldSum::mass, place);
    const Vector2d momentum(interpolated(fields, FieldSum::momentum_x, place),
                            interpolated(fields, FieldSum::momentum_z, place));
    if (mass > 0.0) bed.velocity[i] = momentum.dot(up_slope) / mass;
  }
  const double level = share_of_bulk * percentile(solid, bulk_percentile);
  Index inner = places;
  while (inner >= 0 && !(solid[inner] >= level)) --inner;
  Index surface = inner;
  while (surface > 0 && solid[surface - 1] >= level) --surface;
  if (inner < 0 || !(level > 0.0)) return bed;
  bed.surface_depth = bed.depth[surface];
  bed.surface_speed = 0.0;
  for (Index i = inner; i >= surface; --i) {
    bed.surface_speed = std::fmax(bed.surface_speed, -bed.velocity[i]);
    const bool turns = i < inner && bed.velocity[i] <= 0.0 && bed.velocity[i + 1] > 0.0;
    if (turns && std::isnan(bed.turning_depth))
      bed.turning_depth = bed.depth[i] + zero_between(bed.velocity[i], bed.velocity[i + 1]) *
                                             (bed.depth[i + 1] - bed.depth[i]);
  }
  return bed;
}

}  // namespace millwear::wear
