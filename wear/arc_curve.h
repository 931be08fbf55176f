#pragma once
#include <Eigen/Core>

namespace millwear::wear {

/// A quantity over the arc length of a liner profile, periodic over the pitch: linear between the
/// centres of equal bins, so that its integral over the pitch is sum(values * widths).
struct ArcCurve {
  Eigen::VectorXd bin_edges;  ///< arc length [m], size values.size() + 1, from 0, evenly spaced
  Eigen::VectorXd values;     ///< at the centres of the bins

  /// Value at an arc length [m]; any real number, taken modulo the length of the pitch.
  [[nodiscard]] double at(double arc_length) const;

  /// Length of the pitch along the profile [m].
  [[nodiscard]] double length() const { return bin_edges[bin_edges.size() - 1]; }

  /// Width of a bin [m].
  [[nodiscard]] double bin_width() const { return length() / static_cast<double>(values.size()); }
};

}  // namespace millwear::wear
