#include "wear/numerics/non_negative_least_squares.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mill/base/contract.h"

namespace millwear::wear {
namespace {

constexpr double dependent_within = 1e-10;
constexpr double most_condition = 1e8;

/// Every column divided by its length; columns of zeros stay.
struct ScaledDesign {
  Eigen::MatrixXd columns;
  Eigen::VectorXd lengths;
};

ScaledDesign scaled(const Eigen::MatrixXd& design) {
  ScaledDesign result{design, design.colwise().norm()};
  for (Eigen::Index i = 0; i < design.cols(); ++i)
    if (result.lengths[i] > 0.0) result.columns.col(i) /= result.lengths[i];
  return result;
}

class ActiveSet {
 public:
  ActiveSet(const Eigen::MatrixXd& design, const Eigen::VectorXd& data)
      : design_(design), data_(data), solution_(Eigen::VectorXd::Zero(design.cols())) {}

  /// Frees the component that lowers the sum fastest; false where none does.
  bool free_one() {
    Eigen::VectorXd gradient = design_.transpose() * (data_ - design_ * solution_);
    const double least = 1e-13 * data_.norm();
    for (const Eigen::Index i : free_) gradient[i] = 0.0;
    while (true) {
      Eigen::Index best = 0;
      if (!(gradient.maxCoeff(&best) > least)) return false;
      if (!depends_on_free(best) && solves_above_zero(best)) return true;
      gradient[best] = 0.0;
    }
  }

  [[nodiscard]] const Eigen::VectorXd& solution() const { return solution_; }

 private:
  [[nodiscard]] Eigen::MatrixXd columns(const std::vector<Eigen::Index>& which) const {
    return design_(Eigen::all, which);
  }

  [[nodiscard]] Eigen::VectorXd fit() const {
    Eigen::VectorXd fitted = Eigen::VectorXd::Zero(design_.cols());
    fitted(free_) = columns(free_).householderQr().solve(data_);
    return fitted;
  }

  [[nodiscard]] bool depends_on_free(Eigen::Index column) const {
    if (free_.empty()) return false;
    const Eigen::MatrixXd others = columns(free_);
    const Eigen::VectorXd own = design_.col(column);
    return (own - others * others.householderQr().solve(own)).norm() < dependent_within;
  }

  /// Moves towards the fit with `entering` free, giving up components that would fall below zero on
  /// the way. False, and nothing changed, where the entering one would itself.
  bool solves_above_zero(Eigen::Index entering) {
    free_.push_back(entering);
    Eigen::VectorXd target = fit();
    if (!(target[entering] > 0.0)) {
      free_.pop_back();
      return false;
    }
    while (std::any_of(free_.begin(), free_.end(), [&](auto i) { return target[i] <= 0.0; })) {
      double share = 1.0;
      for (const Eigen::Index i : free_)
        if (target[i] <= 0.0) share = std::min(share, solution_[i] / (solution_[i] - target[i]));
      const Eigen::VectorXd before = solution_;
      solution_ += share * (target - solution_);
      std::erase_if(free_, [&](auto i) {
        const bool reaches_zero =
            target[i] <= 0.0 && before[i] <= share * (before[i] - target[i]) * (1.0 + 1e-12);
        if (reaches_zero) solution_[i] = 0.0;
        return reaches_zero;
      });
      target = fit();
    }
    solution_ = target;
    return true;
  }

  const Eigen::MatrixXd& design_;
  const Eigen::VectorXd& data_;
  Eigen::VectorXd solution_;
  std::vector<Eigen::Index> free_;
};

}  // namespace

Eigen::VectorXd non_negative_least_squares(const Eigen::MatrixXd& design,
                                           const Eigen::VectorXd& data) {
  expect(design.rows() == data.size() && design.rows() > 0 && design.cols() > 0,
         "the design of a least-squares fit has a row for every datum, and columns");
  expect(design.allFinite() && data.allFinite(), "a least-squares fit is of finite numbers");
  const ScaledDesign even = scaled(design);
  ActiveSet set(even.columns, data);
  for (Eigen::Index round = 0; round < 10 * design.cols() && set.free_one(); ++round) {
  }
  Eigen::VectorXd solution = set.solution();
  for (Eigen::Index i = 0; i < solution.size(); ++i)
    if (even.lengths[i] > 0.0) solution[i] /= even.lengths[i];
  return solution;
}

double condition_number(const Eigen::MatrixXd& design) {
  const ScaledDesign even = scaled(design);
  if (design.rows() < design.cols() || !(even.lengths.minCoeff() > 0.0))
    return std::numeric_limits<double>::infinity();
  const Eigen::VectorXd values = Eigen::JacobiSVD<Eigen::MatrixXd>(even.columns).singularValues();
  return values[0] / values[values.size() - 1];
}

Eigen::MatrixXd covariance_of_fit(const Eigen::MatrixXd& design) {
  const Eigen::Index size = design.cols();
  if (!(condition_number(design) < most_condition))
    return Eigen::MatrixXd::Constant(size, size, std::nan(""));
  const ScaledDesign even = scaled(design);
  const Eigen::JacobiSVD<Eigen::MatrixXd> parts(even.columns, Eigen::ComputeThinV);
  const Eigen::MatrixXd root = even.lengths.cwiseInverse().asDiagonal() * parts.matrixV() *
                               parts.singularValues().cwiseInverse().asDiagonal();
  return root * root.transpose();
}

}  // namespace millwear::wear
