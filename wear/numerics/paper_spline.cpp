#include "wear/numerics/paper_spline.h"

#include <gsl/gsl_spline.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <memory>

#include "wear/numerics/gsl_status.h"
#include "wear/numerics/spline_basis.h"

namespace millwear::wear {
namespace {

constexpr Eigen::Index places_per_bin = 8;

struct Release {
  void operator()(gsl_spline* spline) const { gsl_spline_free(spline); }
};

/// What a 1 in the first bin is at the centres of `places` equal parts of the period.
Eigen::VectorXd interpolated_pulse(Eigen::Index bins, Eigen::Index places) {
  const auto nodes = static_cast<std::size_t>(bins) + 1;
  const Eigen::VectorXd at =
      Eigen::VectorXd::LinSpaced(bins + 1, 0.5, static_cast<double>(bins) + 0.5);
  Eigen::VectorXd pulse = Eigen::VectorXd::Zero(bins + 1);
  pulse[0] = pulse[bins] = 1.0;
  const std::unique_ptr<gsl_spline, Release> spline(
      gsl_spline_alloc(gsl_interp_cspline_periodic, nodes));
  if (!spline) check_gsl(GSL_ENOMEM);
  check_gsl(gsl_spline_init(spline.get(), at.data(), pulse.data(), nodes));
  const double period = static_cast<double>(bins);
  Eigen::VectorXd values(places);
  for (Eigen::Index i = 0; i < places; ++i) {
    const double place = (static_cast<double>(i) + 0.5) * period / static_cast<double>(places);
    check_gsl(
        gsl_spline_eval_e(spline.get(), place < 0.5 ? place + period : place, nullptr, &values[i]));
  }
  return values;
}

}  // namespace

LinearSmoother paper_spline(Eigen::Index bins) {
  const QuietGsl quiet;
  const Eigen::Index places = bins * places_per_bin;
  const Eigen::VectorXd pulse = interpolated_pulse(bins, places);
  Eigen::MatrixXd interpolated(places, bins);
  for (Eigen::Index bin = 0; bin < bins; ++bin) {
    const Eigen::Index shift = bin * places_per_bin;
    interpolated.col(bin) << pulse.tail(shift), pulse.head(places - shift);
  }
  const Eigen::Index breaks = std::min(paper_break_points, bins / 2);
  const Eigen::MatrixXd fine = periodic_splines(places, breaks);
  const Eigen::MatrixXd coefficients =
      (fine.transpose() * fine).ldlt().solve(fine.transpose() * interpolated);
  return {periodic_splines(bins, breaks) * coefficients, 0.0, Eigen::MatrixXd(bins, 0)};
}

}  // namespace millwear::wear
