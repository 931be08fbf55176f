#include "wear/calibrate/factor_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "mill/base/contract.h"
#include "mill/base/failure.h"
#include "wear/calibrate/path_prediction.h"
#include "wear/numerics/non_negative_least_squares.h"

namespace millwear::wear {
namespace {

constexpr int most_rounds = 100;
constexpr int most_halvings = 30;
constexpr double settled = 1e-12;
constexpr int starts_per_decade = 8;
constexpr int decades_of_starts = 6;

using Observations = std::vector<LossObservation>;

/// What is left between measured and fitted, over the errors.
struct Misfit {
  Eigen::VectorXd residuals;
  Eigen::MatrixXd design;
  [[nodiscard]] double chi_square() const { return residuals.squaredNorm(); }
};

Misfit misfit_of(const WearPath& path, const Observations& observations,
                 const Eigen::VectorXd& factors) {
  const auto count = static_cast<Eigen::Index>(observations.size());
  Misfit misfit{Eigen::VectorXd(count), Eigen::MatrixXd(count, factors.size())};
  std::map<double, PathLoss> at_time;
  for (Eigen::Index i = 0; i < count; ++i) {
    const LossObservation& seen = observations[static_cast<std::size_t>(i)];
    auto found = at_time.find(seen.time);
    if (found == at_time.end())
      found = at_time.emplace(seen.time, loss_at(path, factors, seen.time)).first;
    misfit.residuals[i] = (seen.lost - found->second.lost[seen.channel]) / seen.error;
    misfit.design.row(i) = found->second.per_factor.row(seen.channel) / seen.error;
  }
  return misfit;
}

Eigen::Index mechanisms_of(const WearPath& path) { return path.pieces.front().start.pace.size(); }

void check(const WearPath& path, const Observations& observations) {
  const Eigen::Index mechanisms = mechanisms_of(path);
  if (static_cast<Eigen::Index>(observations.size()) < mechanisms)
    throw InputError(fmt::format(
        "{} measured values cannot give the coefficients of {} mechanisms; take more readings, or "
        "fewer mechanisms",
        observations.size(), mechanisms));
  for (const auto& seen : observations)
    expect(seen.time > 0.0 && seen.error > 0.0 && std::isfinite(seen.lost) && seen.channel >= 0 &&
               seen.channel < path.channels.count(),
           "a measured loss has a time and an error above zero, and a channel");
  Eigen::VectorXd wear = Eigen::VectorXd::Zero(mechanisms);
  for (const auto& piece : path.pieces) wear += piece.start.pace + piece.end.pace;
  for (Eigen::Index m = 0; m < mechanisms; ++m)
    if (!(wear[m] > 0.0))
      throw InputError(
          fmt::format("mechanism number {} wears nothing under any load of the campaign, so no "
                      "reading can tell its coefficient; leave it out",
                      m + 1));
}

/// The best of many factors common to all mechanisms.
Eigen::VectorXd common_start(const WearPath& path, const Observations& observations) {
  Eigen::VectorXd best;
  double least = std::numeric_limits<double>::infinity();
  for (int i = -decades_of_starts * starts_per_decade; i <= decades_of_starts * starts_per_decade;
       ++i) {
    const Eigen::VectorXd factors = Eigen::VectorXd::Constant(
        mechanisms_of(path), std::pow(10.0, static_cast<double>(i) / starts_per_decade));
    const double chi_square = misfit_of(path, observations, factors).chi_square();
    if (!(chi_square < least)) continue;
    least = chi_square;
    best = factors;
  }
  return best;
}

/// A step from `factors` towards the solution of the linearised problem that lowers chi-square;
/// nothing where there is none.
std::optional<Eigen::VectorXd> better(const WearPath& path, const Observations& observations,
                                      const Eigen::VectorXd& factors, const Misfit& misfit) {
  const Eigen::VectorXd target =
      non_negative_least_squares(misfit.design, misfit.residuals + misfit.design * factors);
  for (double share = 1.0; share > std::ldexp(1.0, -most_halvings); share *= 0.5) {
    const Eigen::VectorXd trial = factors + share * (target - factors);
    if (!(trial.maxCoeff() > 0.0)) continue;
    if (misfit_of(path, observations, trial).chi_square() < misfit.chi_square()) return trial;
  }
  return std::nullopt;
}

}  // namespace

FactorFit fit_factors(const WearPath& path, const Observations& observations,
                      const std::optional<Eigen::VectorXd>& start) {
  check(path, observations);
  Eigen::VectorXd factors = start ? *start : common_start(path, observations);
  Misfit misfit = misfit_of(path, observations, factors);
  for (int round = 0; round < most_rounds; ++round) {
    const auto next = better(path, observations, factors, misfit);
    if (!next) break;
    const double before = misfit.chi_square();
    factors = *next;
    misfit = misfit_of(path, observations, factors);
    if (before - misfit.chi_square() <= settled * before) break;
  }
  return {factors, misfit.chi_square(), misfit.design};
}

std::vector<std::optional<Eigen::VectorXd>> factors_without_each(const WearPath& path,
                                                                 const Observations& observations,
                                                                 const Eigen::VectorXd& factors) {
  std::size_t readings = 0;
  for (const auto& seen : observations) readings = std::max(readings, seen.reading + 1);
  std::vector<std::optional<Eigen::VectorXd>> result(readings);
  for (std::size_t reading = 0; reading < readings; ++reading) {
    Observations others = observations;
    std::erase_if(others, [&](const auto& seen) { return seen.reading == reading; });
    if (static_cast<Eigen::Index>(others.size()) < factors.size()) continue;
    result[reading] = fit_factors(path, others, factors).factors;
  }
  return result;
}

Eigen::VectorXd straight_line(const Observations& observations, Eigen::Index channels,
                              std::optional<std::size_t> without) {
  Eigen::VectorXd products = Eigen::VectorXd::Zero(channels);
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(channels);
  for (const auto& seen : observations) {
    if (seen.reading == without) continue;
    const double weight = seen.time / (seen.error * seen.error);
    products[seen.channel] += weight * seen.lost;
    squares[seen.channel] += weight * seen.time;
  }
  return products.cwiseQuotient(squares);
}

}  // namespace millwear::wear
