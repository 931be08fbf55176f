#include "wear/numerics/arc_curve.h"

#include <cmath>

namespace millwear::wear {

BinsBeside bins_beside(double arc_length, double bin_width, Eigen::Index bins) {
  const double from_first_centre = arc_length / bin_width - 0.5;
  const double left = std::floor(from_first_centre);
  const auto wrapped = [&](double index) {
    const auto modulo = static_cast<Eigen::Index>(std::fmod(index, static_cast<double>(bins)));
    return modulo < 0 ? modulo + bins : modulo;
  };
  return {wrapped(left), wrapped(left + 1.0), from_first_centre - left};
}

ArcCurve as_turned(const ArcCurve& curve, Rotation rotation) {
  return {curve.bin_edges, by_bin_as_turned(curve.values, rotation)};
}

double ArcCurve::at(double arc_length) const {
  const BinsBeside beside = bins_beside(arc_length, bin_width(), values.size());
  return (1.0 - beside.share) * values[beside.left] + beside.share * values[beside.right];
}

}  // namespace millwear::wear
