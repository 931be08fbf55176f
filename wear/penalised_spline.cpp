#include "wear/penalised_spline.h"

#include <fmt/format.h>
#include <gsl/gsl_bspline.h>
#include <gsl/gsl_errno.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "mill/failure.h"

namespace millwear::wear {
namespace {

constexpr std::size_t order = 4;
/// lambda is looked for from where even the roughest shape is kept to where all but one are lost.
constexpr int grid_of_strengths = 200;
constexpr double beyond_the_shapes = 100.0;

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
using Splines = std::unique_ptr<gsl_bspline_workspace, Release<gsl_bspline_free>>;

[[noreturn]] void refuse(const char* reason) {
  throw ResultRejected(fmt::format("the load cannot be smoothed along the profile: {}", reason));
}

void check(int status) {
  if (status != GSL_SUCCESS) refuse(gsl_strerror(status));
}

template <typename Owner, typename T>
Owner allocated(T* object) {
  if (object == nullptr) check(GSL_ENOMEM);
  return Owner(object);
}

/// Rows of the uniform periodic B-splines of period 1 at the centres of the bins: the splines of
/// three more intervals on each side are folded onto the period, where the clamped ends of GSL's
/// knots are out of sight.
Eigen::MatrixXd periodic_design(Eigen::Index bins, Eigen::Index coefficients) {
  const ErrorHandlerOff quiet;
  const std::size_t margin = order - 1;
  const std::size_t breaks = static_cast<std::size_t>(coefficients) + 2 * margin + 1;
  const auto splines = allocated<Splines>(gsl_bspline_alloc(order, breaks));
  const double spacing = 1.0 / static_cast<double>(coefficients);
  const double first = -static_cast<double>(margin) * spacing;
  check(gsl_bspline_knots_uniform(first, 1.0 - first, splines.get()));
  const auto row = allocated<Vector>(gsl_vector_calloc(gsl_bspline_ncoeffs(splines.get())));
  Eigen::MatrixXd design = Eigen::MatrixXd::Zero(bins, coefficients);
  for (Eigen::Index i = 0; i < bins; ++i) {
    const double place = (static_cast<double>(i) + 0.5) / static_cast<double>(bins);
    check(gsl_bspline_eval(place, row.get(), splines.get()));
    for (std::size_t j = margin; j + margin < row->size; ++j) {
      design(i, static_cast<Eigen::Index>(j - margin) % coefficients) +=
          gsl_vector_get(row.get(), j);
    }
  }
  return design;
}

/// D^T D of the periodic second differences D.
Eigen::MatrixXd periodic_penalty(Eigen::Index coefficients) {
  Eigen::MatrixXd difference = Eigen::MatrixXd::Zero(coefficients, coefficients);
  for (Eigen::Index j = 0; j < coefficients; ++j) {
    difference(j, (j + coefficients - 1) % coefficients) += 1.0;
    difference(j, j) -= 2.0;
    difference(j, (j + 1) % coefficients) += 1.0;
  }
  return difference.transpose() * difference;
}

/// The shapes U and their roughness, smoothest first; the first, the constant, has none.
struct Shapes {
  Eigen::MatrixXd at_data;
  Eigen::VectorXd roughness;
};

Shapes shapes_of(const Eigen::MatrixXd& design, const Eigen::VectorXd& weights) {
  const Eigen::MatrixXd normal = design.transpose() * weights.asDiagonal() * design;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      periodic_penalty(design.cols()), normal);
  if (solver.info() != Eigen::Success) refuse("its shapes cannot be told apart");
  Shapes shapes{design * solver.eigenvectors(), solver.eigenvalues().cwiseMax(0.0)};
  shapes.roughness[0] = 0.0;
  if (!shapes.at_data.allFinite()) refuse("a value of a shape is not finite");
  return shapes;
}

Eigen::VectorXd kept_at(const Eigen::VectorXd& roughness, double strength) {
  return (1.0 + strength * strength * roughness.array()).inverse();
}

/// lambda with the least score: the best of a grid even in log lambda, and the vertex of the
/// parabola through it and its two neighbours.
template <typename Score>
double best_strength(const Eigen::VectorXd& roughness, const Score& score) {
  const double from = -0.5 * std::log(roughness.maxCoeff() * beyond_the_shapes);
  const double to = -0.5 * std::log(roughness[1] / beyond_the_shapes);
  const double step = (to - from) / (grid_of_strengths - 1);
  Eigen::VectorXd scores(grid_of_strengths);
  for (int i = 0; i < grid_of_strengths; ++i)
    scores[i] = score(kept_at(roughness, std::exp(from + step * i)));
  Eigen::Index best = 0;
  if (!(scores.minCoeff(&best) < std::numeric_limits<double>::infinity()))
    refuse("no strength of the penalty fits");
  double vertex = static_cast<double>(best);
  if (best > 0 && best + 1 < grid_of_strengths) {
    const double before = scores[best - 1] - scores[best];
    const double after = scores[best + 1] - scores[best];
    if (before + after > 0.0) vertex += 0.5 * (before - after) / (before + after);
  }
  return std::exp(from + step * vertex);
}

}  // namespace

PenalisedFit fit_periodic_spline(const Eigen::VectorXd& values, const Eigen::VectorXd& weights,
                                 Eigen::Index coefficients) {
  auto [shapes, roughness] = shapes_of(periodic_design(values.size(), coefficients), weights);
  const Eigen::VectorXd found = shapes.transpose() * weights.cwiseProduct(values);
  const double outside = std::max(values.cwiseAbs2().dot(weights) - found.squaredNorm(), 0.0);
  const auto residual = [&](const Eigen::VectorXd& kept) {
    return outside + ((1.0 - kept.array()) * found.array()).square().sum();
  };
  const auto freedom = [&](const Eigen::VectorXd& kept) {
    return static_cast<double>(values.size()) - kept.sum();
  };
  const double strength = best_strength(roughness, [&](const Eigen::VectorXd& kept) {
    return residual(kept) / (freedom(kept) * freedom(kept));
  });
  const Eigen::VectorXd kept = kept_at(roughness, strength);
  Eigen::VectorXd smooth = shapes * kept.cwiseProduct(found);
  if (!smooth.allFinite()) refuse("the fit is not finite");
  return {std::move(smooth), strength,
          std::move(shapes), kept,
          weights,           residual(kept) / freedom(kept)};
}

Eigen::MatrixXd fitted(const PenalisedFit& fit, const Eigen::MatrixXd& columns) {
  return fit.shapes *
         (fit.kept.asDiagonal() * (fit.shapes.transpose() * (fit.weights.asDiagonal() * columns)));
}

}  // namespace millwear::wear
