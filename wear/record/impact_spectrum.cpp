#include "wear/record/impact_spectrum.h"

#include <algorithm>
#include <cmath>

namespace millwear::wear {

Eigen::VectorXd energy_edges() {
  const double first = std::log10(least_energy) * energy_classes_per_decade;
  return Eigen::VectorXd::NullaryExpr(energy_classes + 1, [first](Eigen::Index i) {
    return std::pow(10.0, (first + static_cast<double>(i)) / energy_classes_per_decade);
  });
}

Eigen::Index energy_class(double energy) {
  static const Eigen::VectorXd edges = energy_edges();
  if (!(energy > least_energy)) return 0;
  const auto above = std::upper_bound(edges.begin(), edges.end(), energy);
  return std::min<Eigen::Index>(above - edges.begin() - 1, energy_classes - 1);
}

ImpactSpectrum empty_spectrum(Eigen::Index groups) {
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(energy_classes, groups);
  return {none, none, none, none, Eigen::VectorXd::Zero(groups)};
}

void add_collision(ImpactSpectrum& spectrum, Eigen::Index group, double normal_energy,
                   double shear_energy) {
  const Eigen::Index normal = energy_class(normal_energy);
  const Eigen::Index shear = energy_class(shear_energy);
  spectrum.normal_events(normal, group) += 1.0;
  spectrum.normal_energy(normal, group) += normal_energy;
  spectrum.shear_events(shear, group) += 1.0;
  spectrum.shear_energy(shear, group) += shear_energy;
}

void add_spectrum(ImpactSpectrum& sum, const ImpactSpectrum& more) {
  sum.normal_events += more.normal_events;
  sum.normal_energy += more.normal_energy;
  sum.shear_events += more.shear_events;
  sum.shear_energy += more.shear_energy;
  sum.unfinished += more.unfinished;
}

Eigen::Index pair_group(Eigen::Index a, Eigen::Index b, Eigen::Index classes) {
  const Eigen::Index low = std::min(a, b);
  const Eigen::Index high = std::max(a, b);
  return low * classes - low * (low - 1) / 2 + (high - low);
}

Eigen::Index pair_groups(Eigen::Index classes) { return classes * (classes + 1) / 2; }

}  // namespace millwear::wear
