#include "wear/numerics/penalised_spline.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "mill/base/failure.h"
#include "wear/numerics/spline_basis.h"

namespace millwear::wear {
namespace {

/// lambda is looked for from where even the roughest shape is kept to where only the constant is.
constexpr int grid_of_strengths = 200;
constexpr double beyond_the_shapes = 100.0;
/// Of the roughest shape; what is below is rounding.
constexpr double least_roughness = 1e-14;

[[noreturn]] void refuse(const char* reason) {
  throw ResultRejected(fmt::format("the load cannot be smoothed along the profile: {}", reason));
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

/// The shapes U that the penalty tells apart, U^T W U = 1, smoothest first; the first is constant.
struct Shapes {
  Eigen::MatrixXd at_bins;
  Eigen::VectorXd roughness;
};

Shapes shapes_of(const Eigen::MatrixXd& splines, const Eigen::VectorXd& weights) {
  const Eigen::MatrixXd normal = splines.transpose() * weights.asDiagonal() * splines;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      periodic_penalty(splines.cols()), normal);
  if (solver.info() != Eigen::Success) refuse("its shapes cannot be told apart");
  const Eigen::VectorXd roughness = solver.eigenvalues();
  Shapes shapes{splines * solver.eigenvectors(),
                roughness.cwiseMax(least_roughness * roughness.maxCoeff())};
  shapes.roughness[0] = 0.0;
  if (!shapes.at_bins.allFinite()) refuse("a shape is not finite");
  return shapes;
}

Eigen::ArrayXd kept_at(const Eigen::VectorXd& roughness, double strength) {
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
  auto vertex = static_cast<double>(best);
  if (best > 0 && best + 1 < grid_of_strengths) {
    const double before = scores[best - 1] - scores[best];
    const double after = scores[best + 1] - scores[best];
    if (before + after > 0.0) vertex += 0.5 * (before - after) / (before + after);
  }
  return std::exp(from + step * vertex);
}

Eigen::MatrixXd bias_of(const Shapes& shapes, const Eigen::ArrayXd& kept,
                        const Eigen::ArrayXd& noise) {
  const Eigen::ArrayXd lost = (kept * (1.0 - kept)).max(0.0);
  const double weight = lost.sum();
  const double variance = weight > 0.0 ? (lost * noise).sum() / weight : 0.0;
  const Eigen::Index rough = kept.size() - 1;
  return shapes.at_bins.rightCols(rough) *
         (variance * lost.tail(rough)).sqrt().matrix().asDiagonal();
}

}  // namespace

LinearSmoother penalised_spline(const Eigen::VectorXd& values, const Eigen::VectorXd& weights,
                                const Eigen::MatrixXd& deviations, Eigen::Index coefficients) {
  const auto bins = static_cast<double>(values.size());
  const Shapes shapes = shapes_of(periodic_splines(values.size(), coefficients), weights);
  const Eigen::MatrixXd onto_shapes = shapes.at_bins.transpose() * weights.asDiagonal();
  const Eigen::ArrayXd found = (onto_shapes * values).array();
  const double outside =
      std::max(values.cwiseAbs2().dot(weights) - found.matrix().squaredNorm(), 0.0);
  const auto residual = [&](const Eigen::ArrayXd& kept) {
    return outside + ((1.0 - kept) * found).square().sum();
  };
  double strength = best_strength(shapes.roughness, [&](const Eigen::ArrayXd& kept) {
    return residual(kept) / std::pow(bins - kept.sum(), 2);
  });
  Eigen::ArrayXd noise = Eigen::ArrayXd::Zero(coefficients);
  if (deviations.cols() > 0) {
    noise = (onto_shapes * deviations).rowwise().squaredNorm();
    strength = std::max(strength, best_strength(shapes.roughness, [&](const Eigen::ArrayXd& kept) {
                          return residual(kept) + 2.0 * (kept * noise).sum();
                        }));
  }
  const Eigen::ArrayXd kept = kept_at(shapes.roughness, strength);
  return {shapes.at_bins * kept.matrix().asDiagonal() * onto_shapes, strength,
          bias_of(shapes, kept, noise)};
}

}  // namespace millwear::wear
