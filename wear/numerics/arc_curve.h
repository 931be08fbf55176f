#pragma once
#include <Eigen/Core>

#include "mill/liner/rotation.h"

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

/// The curve along the same surface in the other frame (mill/liner/rotation.h).
[[nodiscard]] ArcCurve as_turned(const ArcCurve& curve, Rotation rotation);

/// The two bins between whose centres an arc length lies, over a pitch of even bins.
struct BinsBeside {
  Eigen::Index left;
  Eigen::Index right;
  double share;  ///< of the way from the left centre to the right one, 0 ... 1
};

/// `arc_length` [m] is any real number, taken modulo the length of the pitch.
[[nodiscard]] BinsBeside bins_beside(double arc_length, double bin_width, Eigen::Index bins);

}  // namespace millwear::wear
