#pragma once
#include <Eigen/SparseCore>
#include <vector>

#include "mill/liner/liner_profile.h"
#include "wear/evolve/loss_nodes.h"
#include "wear/numerics/arc_curve.h"
#include "wear/record/profile_index.h"
#include "wear/surface/along_profile.h"
#include "wear/surface/edges.h"

namespace millwear::wear {

/// Carries curves over the arc length of one profile onto profiles that were worn from it.
///
/// A place of the worn profile takes the value of the nearest place of the first that faces the
/// same way, to 60 degrees, where there is one: the faces of a ridge lie nearer to each other than
/// to where they were. Both sides of a place are looked up, a fortieth of a bin away, and averaged.
/// Places of the first profile itself take their own value. Between two bins that an edge of the
/// first profile parts, a place takes the value of the bin on its own side. Linear in the values,
/// so it is a matrix.
class LoadCarrier {
 public:
  using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  /// `bins` even bins along `first`.
  LoadCarrier(const LinerProfile& first, Eigen::Index bins);

  /// A row for every node of `loss_nodes(worn, bin_width(), ...)`, a column for every bin.
  [[nodiscard]] Rows onto_nodes(const LinerProfile& worn) const;

  /// A row for the centre of each of `bins` even bins along `worn`.
  [[nodiscard]] Rows onto_bins(const LinerProfile& worn, Eigen::Index bins) const;

  [[nodiscard]] double bin_width() const { return width_; }

 private:
  [[nodiscard]] Rows onto(const LinerProfile& worn, const std::vector<double>& arc_lengths) const;

  /// Arc length of the nearest place that faces the same way as a place of a worn profile.
  [[nodiscard]] double origin_of(const Eigen::Vector2d& place, const Eigen::Vector2d& along) const;

  /// The bins that a place of the first profile takes its value from.
  [[nodiscard]] BinsBeside bins_of(double arc_length) const;

  LinerProfile first_;
  std::vector<double> lengths_;
  Eigen::Index bins_;
  double width_;
  std::vector<Edge> edges_;
  ProfileIndex index_;
};

}  // namespace millwear::wear
