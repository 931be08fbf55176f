#include "wear/penalised_spline.h"

#include <fmt/format.h>
#include <gsl/gsl_bspline.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit.h>

#include <cmath>
#include <memory>
#include <type_traits>

#include "mill/failure.h"

namespace millwear::wear {
namespace {

constexpr std::size_t order = 4;

class ErrorHandlerOff {
 public:
  ErrorHandlerOff() : previous_(gsl_set_error_handler_off()) {}
  ~ErrorHandlerOff() { gsl_set_error_handler(previous_); }
  ErrorHandlerOff(const ErrorHandlerOff&) = delete;
  ErrorHandlerOff& operator=(const ErrorHandlerOff&) = delete;

 private:
  gsl_error_handler_t* previous_;
};

template <auto release>
struct Release {
  template <typename T>
  void operator()(T* object) const {
    release(object);
  }
};
using Vector = std::unique_ptr<gsl_vector, Release<gsl_vector_free>>;
using Matrix = std::unique_ptr<gsl_matrix, Release<gsl_matrix_free>>;
using Splines = std::unique_ptr<gsl_bspline_workspace, Release<gsl_bspline_free>>;
using Fit = std::unique_ptr<gsl_multifit_linear_workspace, Release<gsl_multifit_linear_free>>;

void check(int status) {
  if (status != GSL_SUCCESS) {
    throw ResultRejected(
        fmt::format("the load cannot be smoothed along the profile: {}", gsl_strerror(status)));
  }
}

template <typename Owner, typename T>
Owner allocated(T* object) {
  if (object == nullptr) check(GSL_ENOMEM);
  return Owner(object);
}

Vector new_vector(std::size_t size) { return allocated<Vector>(gsl_vector_calloc(size)); }
Matrix new_matrix(std::size_t rows, std::size_t columns) {
  return allocated<Matrix>(gsl_matrix_calloc(rows, columns));
}

Vector copy_of(const Eigen::VectorXd& values) {
  auto copy = new_vector(static_cast<std::size_t>(values.size()));
  for (std::size_t i = 0; i < copy->size; ++i) {
    gsl_vector_set(copy.get(), i, values[static_cast<Eigen::Index>(i)]);
  }
  return copy;
}

/// Rows of the uniform periodic B-splines of period 1 at the centres of the bins: the splines of
/// three more intervals on each side are folded onto the period, where the clamped ends of GSL's
/// knots are out of sight.
Matrix periodic_design(std::size_t bins, std::size_t coefficients) {
  const std::size_t margin = order - 1;
  const std::size_t breaks = coefficients + 2 * margin + 1;
  const auto splines = allocated<Splines>(gsl_bspline_alloc(order, breaks));
  const double spacing = 1.0 / static_cast<double>(coefficients);
  const double first = -static_cast<double>(margin) * spacing;
  check(gsl_bspline_knots_uniform(first, 1.0 - first, splines.get()));
  auto design = new_matrix(bins, coefficients);
  auto row = new_vector(gsl_bspline_ncoeffs(splines.get()));
  for (std::size_t i = 0; i < bins; ++i) {
    const double place = (static_cast<double>(i) + 0.5) / static_cast<double>(bins);
    check(gsl_bspline_eval(place, row.get(), splines.get()));
    for (std::size_t j = margin; j + margin < row->size; ++j) {
      const std::size_t column = (j - margin) % coefficients;
      *gsl_matrix_ptr(design.get(), i, column) += gsl_vector_get(row.get(), j);
    }
  }
  return design;
}

/// A factor L of full row rank with L^T L = D^T D, D the periodic second differences. D has the
/// constant vector in both its null spaces, so L = Q^T D with the Helmert basis Q of its
/// complement.
Matrix periodic_penalty(std::size_t coefficients) {
  auto penalty = new_matrix(coefficients - 1, coefficients);
  for (std::size_t k = 1; k < coefficients; ++k) {
    const auto count = static_cast<double>(k);
    const double norm = 1.0 / std::sqrt(count * (count + 1.0));
    for (std::size_t row = 0; row <= k; ++row) {
      const double helmert = row < k ? norm : -count * norm;
      *gsl_matrix_ptr(penalty.get(), k - 1, (row + coefficients - 1) % coefficients) += helmert;
      *gsl_matrix_ptr(penalty.get(), k - 1, row) -= 2.0 * helmert;
      *gsl_matrix_ptr(penalty.get(), k - 1, (row + 1) % coefficients) += helmert;
    }
  }
  return penalty;
}

}  // namespace

PenalisedFit fit_periodic_spline(const Eigen::VectorXd& values, const Eigen::VectorXd& weights,
                                 Eigen::Index coefficients) {
  const ErrorHandlerOff quiet;
  const auto n = static_cast<std::size_t>(values.size());
  const auto p = static_cast<std::size_t>(coefficients);
  constexpr std::size_t grid_of_strengths = 200;
  const auto design = periodic_design(n, p);
  const auto penalty = periodic_penalty(p);
  const auto tau = new_vector(p - 1);
  const auto y = copy_of(values);
  const auto w = copy_of(weights);
  const auto fit = allocated<Fit>(gsl_multifit_linear_alloc(n, p));
  const auto standard_design = new_matrix(n - 1, p - 1);
  const auto standard_y = new_vector(n - 1);
  const auto back = new_matrix(n, p);
  const auto standard_c = new_vector(p - 1);
  const auto c = new_vector(p);
  const auto strengths = new_vector(grid_of_strengths);
  const auto scores = new_vector(grid_of_strengths);
  double strength = 0.0;
  double score = 0.0;
  double residual = 0.0;
  double roughness = 0.0;

  check(gsl_multifit_linear_L_decomp(penalty.get(), tau.get()));
  check(gsl_multifit_linear_wstdform2(penalty.get(), tau.get(), design.get(), w.get(), y.get(),
                                      standard_design.get(), standard_y.get(), back.get(),
                                      fit.get()));
  check(gsl_multifit_linear_svd(standard_design.get(), fit.get()));
  check(gsl_multifit_linear_gcv(standard_y.get(), strengths.get(), scores.get(), &strength, &score,
                                fit.get()));
  check(gsl_multifit_linear_solve(strength, standard_design.get(), standard_y.get(),
                                  standard_c.get(), &residual, &roughness, fit.get()));
  check(gsl_multifit_linear_wgenform2(penalty.get(), tau.get(), design.get(), w.get(), y.get(),
                                      standard_c.get(), back.get(), c.get(), fit.get()));

  PenalisedFit result{Eigen::VectorXd::Zero(values.size()), strength};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < p; ++j) {
      result.values[static_cast<Eigen::Index>(i)] +=
          gsl_matrix_get(design.get(), i, j) * gsl_vector_get(c.get(), j);
    }
  }
  if (!result.values.allFinite()) check(GSL_EFAILED);
  return result;
}

}  // namespace millwear::wear
