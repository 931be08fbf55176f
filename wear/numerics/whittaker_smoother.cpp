#include "wear/numerics/whittaker_smoother.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "mill/base/failure.h"

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
Eigen::MatrixXd penalty_of(const Eigen::VectorXd& spacing) {
  const Eigen::Index n = spacing.size();
  const double cube = std::pow(spacing.mean(), 3);
  Eigen::MatrixXd penalty = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index before = (i + n - 1) % n;
    const Eigen::Index at[] = {before, i, (i + 1) % n};
    const double back = 1.0 / spacing[before];
    const double on = 1.0 / spacing[i];
    const double second[] = {back, -back - on, on};
    const double scale = cube / (0.5 * (spacing[before] + spacing[i]));
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        penalty(at[row], at[column]) += scale * second[row] * second[column];
  }
  return penalty;
}

/// The shapes U that the penalty tells apart, U^T W U = 1, smoothest first; the constant has no
/// roughness.
struct Shapes {
  Eigen::MatrixXd at_bins;
  Eigen::VectorXd roughness;
};

Shapes shapes_of(const Eigen::VectorXd& spacing, const Eigen::VectorXd& weights) {
  const Eigen::VectorXd scale = weights.cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      scale.asDiagonal() * penalty_of(spacing) * scale.asDiagonal());
  if (solver.info() != Eigen::Success) refuse("its shapes cannot be told apart");
  const Eigen::VectorXd roughness = solver.eigenvalues();
  const double least = least_roughness * roughness.maxCoeff();
  Shapes shapes{scale.asDiagonal() * solver.eigenvectors(),
                (roughness.array() > least).select(roughness, 0.0)};
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
  const double smoothest =
      (roughness.array() > 0.0).select(roughness, roughness.maxCoeff()).minCoeff();
  const double from = -0.5 * std::log(roughness.maxCoeff() * beyond_the_shapes);
  const double to = -0.5 * std::log(smoothest / beyond_the_shapes);
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
  return shapes.at_bins * (variance * lost).sqrt().matrix().asDiagonal();
}

}  // namespace

LinearSmoother whittaker_smoother(const Eigen::VectorXd& values, const Eigen::VectorXd& weights,
                                  const Eigen::MatrixXd& deviations, const Eigen::VectorXd& spacing,
                                  double least_strength) {
  const auto bins = static_cast<double>(values.size());
  const Shapes shapes = shapes_of(spacing, weights);
  const Eigen::MatrixXd onto_shapes = shapes.at_bins.transpose() * weights.asDiagonal();
  const Eigen::ArrayXd found = (onto_shapes * values).array();
  const auto residual = [&](const Eigen::ArrayXd& kept) {
    return ((1.0 - kept) * found).square().sum();
  };
  double strength = best_strength(shapes.roughness, [&](const Eigen::ArrayXd& kept) {
    return residual(kept) / std::pow(bins - kept.sum(), 2);
  });
  Eigen::ArrayXd noise = Eigen::ArrayXd::Zero(values.size());
  if (deviations.cols() > 0) {
    noise = (onto_shapes * deviations).rowwise().squaredNorm();
    strength = std::max(strength, best_strength(shapes.roughness, [&](const Eigen::ArrayXd& kept) {
                          return residual(kept) + 2.0 * (kept * noise).sum();
                        }));
  }
  strength = std::max(strength, least_strength);
  const Eigen::ArrayXd kept = kept_at(shapes.roughness, strength);
  return {shapes.at_bins * kept.matrix().asDiagonal() * onto_shapes, strength,
          bias_of(shapes, kept, noise)};
}

}  // namespace millwear::wear
