#include "wear/calibrate/calibration.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mill/base/failure.h"
#include "wear/calibrate/path_prediction.h"
#include "wear/numerics/non_negative_least_squares.h"

namespace millwear::wear {
namespace {

using Observations = std::vector<LossObservation>;

/// chi-square of a liner that does not wear.
double nothing_worn(const Observations& observations) {
  double sum = 0.0;
  for (const auto& seen : observations) sum += std::pow(seen.lost / seen.error, 2);
  return sum;
}

/// The path with some of its mechanisms alone.
WearPath with_mechanisms(const WearPath& path, const std::vector<Eigen::Index>& which) {
  WearPath result = path;
  for (auto& piece : result.pieces)
    for (auto* rates : {&piece.start, &piece.end}) {
      rates->pace = rates->pace(which).eval();
      rates->losses = rates->losses(Eigen::all, which).eval();
    }
  return result;
}

/// chi-square of the best fit without some mechanisms; infinite without all.
double chi_square_without(const WearPath& path, const Observations& observations,
                          const std::vector<Eigen::Index>& left_out) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index m = 0; m < path.pieces.front().start.pace.size(); ++m)
    if (std::find(left_out.begin(), left_out.end(), m) == left_out.end()) kept.push_back(m);
  if (kept.empty()) return std::numeric_limits<double>::infinity();
  return fit_factors(with_mechanisms(path, kept), observations).chi_square;
}

Eigen::MatrixXd correlations(const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd scale = covariance.diagonal().cwiseSqrt().cwiseInverse();
  return scale.asDiagonal() * covariance * scale.asDiagonal();
}

/// Covariance of the factors above zero, those at zero held there.
Eigen::MatrixXd covariance_above_zero(const FactorFit& fit) {
  std::vector<Eigen::Index> above;
  for (Eigen::Index m = 0; m < fit.factors.size(); ++m)
    if (fit.factors[m] > 0.0) above.push_back(m);
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(fit.factors.size(), fit.factors.size());
  covariance(above, above) = covariance_of_fit(fit.design(Eigen::all, above));
  return covariance;
}

/// What every mechanism with the factor 1 takes by the last reading: of all zones together where it
/// has them, else of its first channel.
Eigen::VectorXd taken_by_last_reading(const WearPath& path, const Observations& observations,
                                      const Eigen::VectorXd& factors) {
  const auto last = std::max_element(observations.begin(), observations.end(),
                                     [](const auto& a, const auto& b) { return a.time < b.time; });
  const Eigen::MatrixXd taken = loss_at(path, factors, last->time).taken;
  if (last->channel < path.channels.zones)
    return taken.topRows(path.channels.zones).colwise().sum().transpose();
  return taken.row(last->channel).transpose();
}

/// What the search for mechanisms that cannot be told apart looks at.
struct Evidence {
  const WearPath& path;
  const Observations& observations;
  const Calibration& calibration;
  Eigen::MatrixXd correlation;  ///< of all factors were they free; NaN where dependent
  Eigen::VectorXd taken;        ///< at the last reading
};

Likeness likeness_of(const Evidence& evidence, Eigen::Index first, Eigen::Index second) {
  const Calibration& found = evidence.calibration;
  const double doubt = rise_of_doubt * found.error_scale * found.error_scale;
  const double chi_square = found.fit.chi_square;
  const bool either_can_go =
      found.rise_without[first] < doubt && found.rise_without[second] < doubt;
  const bool one_must_stay =
      either_can_go &&
      chi_square_without(evidence.path, evidence.observations, {first, second}) - chi_square >=
          doubt;
  Eigen::VectorXd both = Eigen::VectorXd::Zero(evidence.taken.size());
  both[first] = evidence.taken[first];
  both[second] = evidence.taken[second];
  return {static_cast<std::size_t>(first),     static_cast<std::size_t>(second),
          evidence.correlation(first, second), one_must_stay,
          both.dot(found.fit.factors),         std::sqrt(both.dot(found.covariance * both))};
}

std::vector<Likeness> pairs_alike(const Evidence& evidence) {
  std::vector<Likeness> alike;
  for (Eigen::Index first = 0; first < evidence.taken.size(); ++first)
    for (Eigen::Index second = first + 1; second < evidence.taken.size(); ++second) {
      const Likeness pair = likeness_of(evidence, first, second);
      if (pair.exchangeable || std::abs(pair.correlation) > correlation_of_doubt)
        alike.push_back(pair);
    }
  return alike;
}

}  // namespace

Calibration calibrate(const WearPath& path, const Observations& observations) {
  Calibration result{fit_factors(path, observations), 0, 1.0, {}, {}, {}, 0.0, {}};
  const FactorFit& fit = result.fit;
  if (fit.chi_square >= nothing_worn(observations))
    throw ResultRejected(
        "the readings show no wear: no coefficient above zero fits them better than none");
  const Eigen::Index mechanisms = fit.factors.size();
  result.freedom = static_cast<long>(observations.size()) - (fit.factors.array() > 0.0).count();
  if (result.freedom > 0)
    result.error_scale =
        std::sqrt(std::max(1.0, fit.chi_square / static_cast<double>(result.freedom)));
  const double scale = result.error_scale * result.error_scale;
  result.covariance = scale * covariance_above_zero(fit);
  const Eigen::MatrixXd free = scale * covariance_of_fit(fit.design);
  result.errors =
      (fit.factors.array() > 0.0).select(result.covariance.diagonal(), free.diagonal()).cwiseSqrt();
  result.condition = condition_number(fit.design);
  result.rise_without.resize(mechanisms);
  for (Eigen::Index m = 0; m < mechanisms; ++m)
    result.rise_without[m] =
        std::max(0.0, chi_square_without(path, observations, {m}) - fit.chi_square);
  result.alike = pairs_alike({path, observations, result, correlations(free),
                              taken_by_last_reading(path, observations, fit.factors)});
  return result;
}

}  // namespace millwear::wear
