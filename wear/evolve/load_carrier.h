#pragma once
#include <Eigen/SparseCore>
#include <vector>

#include "mill/liner/liner_profile.h"
#include "wear/evolve/loss_nodes.h"
#include "wear/numerics/arc_curve.h"
#include "wear/record/profile_index.h"

namespace millwear::wear {

/// Carries curves over the arc length of one profile onto profiles that were worn from it.
///
/// A place of the worn profile takes the value of the nearest place of the first. Both sides of a
/// place are looked up, a fortieth of a bin away, and averaged, because a corner of the worn
/// profile is as near to one face as to the other. Places of the first profile itself take their
/// own value. Linear in the values, so it is a matrix.
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

  LinerProfile first_;
  Eigen::Index bins_;
  double width_;
  ProfileIndex index_;
};

/// The place of a profile at an arc length [m], taken modulo the length of the pitch.
[[nodiscard]] Eigen::Vector2d place_at(const LinerProfile& profile,
                                       const std::vector<double>& arc_lengths, double arc_length);

}  // namespace millwear::wear
