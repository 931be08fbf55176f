#pragma once
#include <Eigen/Core>
#include <vector>

namespace millwear::wear {

/// A 95 % band.
struct Band {
  double low;
  double high;
};

/// The standard error of a normal distribution whose 95 % have the band's width.
[[nodiscard]] double standard_error_of(const Band& band);

/// The 2.5 and 97.5 % quantiles of replicates, linear between them; NaN for fewer than two.
[[nodiscard]] Band band_of(Eigen::VectorXd replicates);

/// The replicates of a liner at one time.
struct ReplicatesInTime {
  double time;              ///< of milling since the liner was new [s]
  Eigen::VectorXd heights;  ///< lifter height of each [m]
  Eigen::VectorXd plates;   ///< least plate thickness of each [m]
};

/// How fast the replicates (columns) went down in the mean from the last moment (row) up to `since`
/// to the end; `times` are of the moments.
[[nodiscard]] double mean_speed(const std::vector<double>& times, const Eigen::MatrixXd& values,
                                double since);

/// When each replicate is worn out [s]: the first time that its height or its plate is at its limit
/// [m], linear between the times of `course`. One that is not there by the end goes on as fast as
/// all of them did in the mean since `last_load` [s]: its own noise of that time says nothing of a
/// load that is yet to come. NaN where they do not wear. `course` is in the order of time.
[[nodiscard]] Eigen::VectorXd lives(const std::vector<ReplicatesInTime>& course,
                                    double height_limit, double plate_limit, double last_load);

}  // namespace millwear::wear
