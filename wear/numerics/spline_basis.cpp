#include "wear/numerics/spline_basis.h"

#include <gsl/gsl_bspline.h>

#include <memory>

#include "wear/numerics/gsl_status.h"

namespace millwear::wear {
namespace {

constexpr std::size_t order = 4;

struct Release {
  void operator()(gsl_bspline_workspace* splines) const { gsl_bspline_free(splines); }
  void operator()(gsl_vector* vector) const { gsl_vector_free(vector); }
};

}  // namespace

// The splines of three more intervals on each side are folded onto the period, where the clamped
// ends of GSL's knots are out of sight.
Eigen::MatrixXd periodic_splines(Eigen::Index places, Eigen::Index coefficients) {
  const QuietGsl quiet;
  const std::size_t margin = order - 1;
  const std::size_t breaks = static_cast<std::size_t>(coefficients) + 2 * margin + 1;
  const std::unique_ptr<gsl_bspline_workspace, Release> splines(gsl_bspline_alloc(order, breaks));
  if (!splines) check_gsl(GSL_ENOMEM);
  const double spacing = 1.0 / static_cast<double>(coefficients);
  const double first = -static_cast<double>(margin) * spacing;
  check_gsl(gsl_bspline_knots_uniform(first, 1.0 - first, splines.get()));
  const std::unique_ptr<gsl_vector, Release> row(
      gsl_vector_calloc(gsl_bspline_ncoeffs(splines.get())));
  if (!row) check_gsl(GSL_ENOMEM);
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(places, coefficients);
  for (Eigen::Index i = 0; i < places; ++i) {
    const double place = (static_cast<double>(i) + 0.5) / static_cast<double>(places);
    check_gsl(gsl_bspline_eval(place, row.get(), splines.get()));
    for (std::size_t j = margin; j + margin < row->size; ++j) {
      values(i, static_cast<Eigen::Index>(j - margin) % coefficients) +=
          gsl_vector_get(row.get(), j);
    }
  }
  return values;
}

}  // namespace millwear::wear
