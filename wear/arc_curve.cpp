#include "wear/arc_curve.h"

#include <cmath>

namespace millwear::wear {

double ArcCurve::at(double arc_length) const {
  const Eigen::Index bins = values.size();
  const double from_first_centre = arc_length / bin_width() - 0.5;
  const double left = std::floor(from_first_centre);
  const double share = from_first_centre - left;
  const auto wrapped = [&](double index) {
    const auto modulo = static_cast<Eigen::Index>(std::fmod(index, static_cast<double>(bins)));
    return modulo < 0 ? modulo + bins : modulo;
  };
  return (1.0 - share) * values[wrapped(left)] + share * values[wrapped(left + 1.0)];
}

}  // namespace millwear::wear
