#include "wear/numerics/non_negative_least_squares.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace millwear::wear {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

double between(int low, int high) { return *rc::gen::inRange(low, high) * 1e-2; }

struct Problem {
  MatrixXd design;
  VectorXd data;
};

/// Columns of one sign and of both, sometimes one the multiple of another.
Problem random_problem() {
  const auto columns = *rc::gen::inRange<Eigen::Index>(1, 6);
  const auto rows = *rc::gen::inRange<Eigen::Index>(columns, 12);
  Problem problem{MatrixXd(rows, columns), VectorXd(rows)};
  for (double& value : problem.design.reshaped()) value = between(-80, 100);
  for (double& value : problem.data) value = between(-100, 100);
  if (columns > 2 && *rc::gen::inRange(0, 4) == 0)
    problem.design.col(1) = 3.0 * problem.design.col(0);
  return problem;
}

/// The least sum of squares over every choice of free columns whose fit is not below zero.
double least_sum(const Problem& problem) {
  const auto columns = problem.design.cols();
  double least = problem.data.squaredNorm();
  for (unsigned choice = 1; choice < 1U << static_cast<unsigned>(columns); ++choice) {
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < columns; ++i)
      if ((choice >> static_cast<unsigned>(i) & 1U) != 0) free.push_back(i);
    const MatrixXd part = problem.design(Eigen::all, free);
    const VectorXd fit = part.colPivHouseholderQr().solve(problem.data);
    if (fit.minCoeff() >= 0.0) least = std::min(least, (part * fit - problem.data).squaredNorm());
  }
  return least;
}

RC_GTEST_PROP(NonNegativeLeastSquares, IsTheBestOfAllActiveSets, ()) {
  const Problem problem = random_problem();
  const VectorXd x = non_negative_least_squares(problem.design, problem.data);
  const double sum = (problem.design * x - problem.data).squaredNorm();
  RC_ASSERT(x.minCoeff() >= 0.0);
  RC_ASSERT(sum <= least_sum(problem) + 1e-9 * problem.data.squaredNorm());
}

// The conditions of Karush, Kuhn and Tucker: the gradient is zero where x > 0 and lowers the sum
// nowhere else.
RC_GTEST_PROP(NonNegativeLeastSquares, MeetsItsOptimalityConditions, ()) {
  const Problem problem = random_problem();
  const VectorXd x = non_negative_least_squares(problem.design, problem.data);
  const VectorXd gradient = problem.design.transpose() * (problem.data - problem.design * x);
  const double small = 1e-9 * (1.0 + problem.data.norm()) * (1.0 + problem.design.norm()) + 1e-12;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    RC_ASSERT(gradient[i] <= small);
    if (x[i] > 0.0) RC_ASSERT(std::abs(gradient[i]) <= small);
  }
}

// Coefficients of wear are 1e-12, their columns 1e9: the units do not matter.
RC_GTEST_PROP(NonNegativeLeastSquares, ScalesWithTheUnits, ()) {
  const Problem problem = random_problem();
  const VectorXd here = non_negative_least_squares(problem.design, problem.data);
  const VectorXd there =
      non_negative_least_squares(1e9 * problem.design, 1e-3 * problem.data) * 1e12;
  RC_ASSERT((problem.design * (here - there)).norm() <= 1e-7 * (1.0 + problem.data.norm()));
}

// x = 1 and y = 2 give exactly (1, 2, 3).
TEST(NonNegativeLeastSquares, FindsAnExactSolution) {
  const MatrixXd design{{1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}};
  const VectorXd x = non_negative_least_squares(design, VectorXd{{1.0, 2.0, 3.0}});
  EXPECT_NEAR(x[0], 1.0, 1e-14);
  EXPECT_NEAR(x[1], 2.0, 1e-14);
}

// The free fit of (1, 0) is (2, -1); with y = 0 the best x is 1/2 ((1, 1) on (1, 0)).
TEST(NonNegativeLeastSquares, StopsAtZero) {
  const MatrixXd design{{1.0, 1.0}, {1.0, 2.0}};
  const VectorXd x = non_negative_least_squares(design, VectorXd{{1.0, 0.0}});
  EXPECT_NEAR(x[0], 0.5, 1e-14);
  EXPECT_EQ(x[1], 0.0);
}

// (1, 1, 0.5) is nearest to (1, 1, -0.1) and is freed first; with the others free it would be -0.2,
// and without it they are 1 each.
TEST(NonNegativeLeastSquares, GivesUpWhatItTookFirst) {
  const MatrixXd design{{1.0, 1.0, 0.0}, {1.0, 0.0, 1.0}, {0.5, 0.0, 0.0}};
  const VectorXd x = non_negative_least_squares(design, VectorXd{{1.0, 1.0, -0.1}});
  EXPECT_EQ(x[0], 0.0);
  EXPECT_NEAR(x[1], 1.0, 1e-14);
  EXPECT_NEAR(x[2], 1.0, 1e-14);
}

TEST(NonNegativeLeastSquares, GivesAllToOneOfTwoEqualColumns) {
  const MatrixXd design{{1.0, 2.0, 0.0}, {2.0, 4.0, 0.0}};
  const VectorXd x = non_negative_least_squares(design, VectorXd{{3.0, 6.0}});
  EXPECT_EQ(std::min(x[0], x[1]), 0.0);
  EXPECT_NEAR(x[0] + 2.0 * x[1], 3.0, 1e-14);
  EXPECT_EQ(x[2], 0.0);
}

TEST(NonNegativeLeastSquares, RefusesWhatIsNoProblem) {
  EXPECT_THROW(static_cast<void>(non_negative_least_squares(MatrixXd(2, 1), VectorXd(3))),
               std::logic_error);
  EXPECT_THROW(static_cast<void>(non_negative_least_squares(MatrixXd::Constant(1, 1, std::nan("")),
                                                            VectorXd::Ones(1))),
               std::logic_error);
}

// Two readings of error 1 of x, one of 10 y: variances 1/2 and 1/100.
TEST(CovarianceOfFit, IsTheInverseOfTheInformation) {
  const MatrixXd covariance = covariance_of_fit(MatrixXd{{1.0, 0.0}, {1.0, 0.0}, {0.0, 10.0}});
  EXPECT_NEAR(covariance(0, 0), 0.5, 1e-15);
  EXPECT_NEAR(covariance(1, 1), 0.01, 1e-15);
  EXPECT_NEAR(covariance(0, 1), 0.0, 1e-15);
}

TEST(CovarianceOfFit, IsUnknownForDependentColumns) {
  EXPECT_TRUE(std::isnan(covariance_of_fit(MatrixXd{{1.0, 2.0}, {2.0, 4.0}})(0, 0)));
  EXPECT_EQ(condition_number(MatrixXd{{1.0, 2.0}}), std::numeric_limits<double>::infinity());
  EXPECT_NEAR(condition_number(MatrixXd{{1e-9, 0.0}, {0.0, 1e9}}), 1.0, 1e-14);
}

}  // namespace
}  // namespace millwear::wear
