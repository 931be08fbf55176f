#pragma once
#include <Eigen/Core>
#include <vector>

namespace millwear::wear {

/// A scan's points along a curve, averaged in turn: first so many that eight means fall on a
/// `spacing` [m], so that noise does not tell the points' order, then those within `spacing` of the
/// first of a group. A curve whose nodes lie farther apart
/// stays as it is; the ends are carried on to where the scan ends. Corners
/// lose up to half of `spacing`. Throws InputError where the points are not in the order of
/// the curve (the means run back and forth over more than four times the scan's extent).
[[nodiscard]] std::vector<Eigen::Vector2d> averaged_scan(const std::vector<Eigen::Vector2d>& curve,
                                                         double spacing);

/// What is kept of a curve from a gauge, `error` [m] the standard error of its places:
/// - nodes that are not closer than that (by the median), and no more than `most`, stay;
/// - a dense curve without noise (averaging would shorten it by less than a tenth) loses the nodes
///   that lie within a tenth of `error` of the line between those that stay;
/// - a dense noisy scan, or one that is left with more than `most`, is averaged over three errors.
[[nodiscard]] std::vector<Eigen::Vector2d> thinned_scan(const std::vector<Eigen::Vector2d>& curve,
                                                        double error, std::size_t most);

/// The groups that `thinned_scan` averages over [m].
[[nodiscard]] double group_of_scan(const std::vector<Eigen::Vector2d>& curve, double error,
                                   std::size_t most);

/// Half of the way round the box that holds the curve [m].
[[nodiscard]] double extent_of(const std::vector<Eigen::Vector2d>& curve);

}  // namespace millwear::wear
