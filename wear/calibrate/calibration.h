#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "wear/calibrate/factor_fit.h"
#include "wear/calibrate/wear_path.h"

namespace millwear::wear {

/// Two mechanisms that the readings hardly tell apart.
struct Likeness {
  std::size_t first;
  std::size_t second;
  double correlation;  ///< of the two factors; NaN where their columns are dependent
  /// Each can go without chi-square rising by `rise_of_doubt` (times `error_scale`^2), but not
  /// both; or their columns are dependent: one of them explains the readings as well as the two.
  bool exchangeable;
  double lost;   ///< by both together at the last reading, all its channels summed [m2] or [m]
  double error;  ///< its standard error
};

/// chi-square rises by this where a factor is two standard errors from zero.
inline constexpr double rise_of_doubt = 4.0;
/// Factors correlated beyond this are hard to tell apart.
inline constexpr double correlation_of_doubt = 0.95;

struct Calibration {
  FactorFit fit;
  long freedom;                ///< observations less factors above zero
  double error_scale;          ///< sqrt(max(1, chi_square / freedom)): all errors hold this factor
  Eigen::MatrixXd covariance;  ///< of the factors above zero; rows of the others are zero
  /// Standard errors. Of a factor that ends at zero: what it would be were all free. NaN where the
  /// columns are dependent.
  Eigen::VectorXd errors;
  Eigen::VectorXd
      rise_without;  ///< of chi-square where a mechanism is left out and the rest fitted
  double condition;  ///< condition number of the design, columns scaled to length 1
  std::vector<Likeness> alike;
};

/// The fit with its errors and what it cannot tell. Throws as `fit_factors`, and ResultRejected
/// where the readings show no wear.
[[nodiscard]] Calibration calibrate(const WearPath& path,
                                    const std::vector<LossObservation>& observations);

}  // namespace millwear::wear
