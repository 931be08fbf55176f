#include "wear/calibrate/path_prediction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace millwear::wear {
namespace {

/// Gauss and Legendre's places in 0 ... 1 and their weights.
constexpr std::array places = {0.1127016653792583, 0.5, 0.8872983346207417};
constexpr std::array weights = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};

/// A pace below this share of the greatest on the path counts as it, so that all stays finite.
constexpr double least_pace_share = 1e-12;

struct Pace {
  double start;
  double end;
};

Pace pace_on(const PathPiece& piece, const Eigen::VectorXd& factors, double least) {
  return {std::max(least, piece.start.pace.dot(factors)),
          std::max(least, piece.end.pace.dot(factors))};
}

/// Time over a whole piece whose pace is linear: int dA / p.
double time_over(double section, const Pace& pace) {
  const double growth = (pace.end - pace.start) / pace.start;
  return section / pace.start * (std::abs(growth) < 1e-9 ? 1.0 : std::log1p(growth) / growth);
}

/// Section worn after `time` on a piece: the inverse, A = p t (e^(s t) - 1) / (s t).
double section_after(double time, double section, const Pace& pace) {
  const double growth = time * (pace.end - pace.start) / section;
  return pace.start * time * (std::abs(growth) < 1e-9 ? 1.0 : std::expm1(growth) / growth);
}

double least_pace(const WearPath& path, const Eigen::VectorXd& factors) {
  double most = std::numeric_limits<double>::min();
  for (const auto& piece : path.pieces)
    most = std::max({most, piece.start.pace.dot(factors), piece.end.pace.dot(factors)});
  return least_pace_share * most;
}

/// Integrals along the path up to a place, and their change with the factors at a fixed place.
struct Integrals {
  Eigen::VectorXd time_per_factor;   ///< int pace_m / p^2 dA: - dT/df_m
  Eigen::MatrixXd taken;             ///< int r_mc / p dA
  Eigen::MatrixXd per_factor;        ///< int (r_mc / p - R_c pace_m / p^2) dA
  Eigen::VectorXd loss_per_section;  ///< R_c / p at the end
  double pace;                       ///< p at the end

  Integrals(Eigen::Index channels, Eigen::Index mechanisms)
      : time_per_factor(Eigen::VectorXd::Zero(mechanisms)),
        taken(Eigen::MatrixXd::Zero(channels, mechanisms)),
        per_factor(Eigen::MatrixXd::Zero(channels, mechanisms)),
        loss_per_section(Eigen::VectorXd::Zero(channels)),
        pace(0.0) {}
};

struct At {
  Eigen::VectorXd paces;
  Eigen::MatrixXd losses;
};

At rates_at(const PathPiece& piece, double share) {
  return {(1.0 - share) * piece.start.pace + share * piece.end.pace,
          (1.0 - share) * piece.start.losses + share * piece.end.losses};
}

/// Adds the first `section` of a piece.
void add(Integrals& sums, const PathPiece& piece, double section, const Eigen::VectorXd& factors,
         double least) {
  const double part = section / piece.section;
  const auto pace_at = [&](const At& rates) { return std::max(least, rates.paces.dot(factors)); };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const At rates = rates_at(piece, part * places[i]);
    const double pace = pace_at(rates);
    const double time = weights[i] * section / pace;
    const Eigen::VectorXd total = rates.losses * factors;
    sums.time_per_factor += time / pace * rates.paces;
    sums.taken += time * rates.losses;
    sums.per_factor += time * (rates.losses - total * (rates.paces / pace).transpose());
  }
  const At rates = rates_at(piece, part);
  sums.pace = pace_at(rates);
  sums.loss_per_section = rates.losses * factors / sums.pace;
}

/// The last rates of the path, for as long as it takes.
PathPiece beyond(const WearPath& path) {
  const PathPiece& last = path.pieces.back();
  double whole = 0.0;
  for (const auto& piece : path.pieces) whole += piece.section;
  return {whole, last.end, last.end};
}

}  // namespace

PathLoss loss_at(const WearPath& path, const Eigen::VectorXd& factors, double time) {
  const double least = least_pace(path, factors);
  Integrals sums(path.channels.count(), factors.size());
  double left = time;
  bool ends = false;
  for (auto piece = path.pieces.begin(); piece != path.pieces.end() && !ends; ++piece) {
    const Pace pace = pace_on(*piece, factors, least);
    const double whole = time_over(piece->section, pace);
    ends = left <= whole;
    const double section =
        ends ? std::min(piece->section, section_after(left, piece->section, pace)) : piece->section;
    add(sums, *piece, section, factors, least);
    left -= whole;
  }
  if (!ends) {
    const PathPiece more = beyond(path);
    add(sums, more, pace_on(more, factors, least).start * left, factors, least);
  }
  const Eigen::VectorXd place_per_factor = sums.pace * sums.time_per_factor;
  return {sums.taken * factors, sums.taken,
          sums.per_factor + sums.loss_per_section * place_per_factor.transpose()};
}

double time_of_path(const WearPath& path, const Eigen::VectorXd& factors) {
  double time = 0.0;
  for (const auto& piece : path.pieces) {
    const double start = piece.start.pace.dot(factors);
    const double end = piece.end.pace.dot(factors);
    if (!(start > 0.0 && end > 0.0)) return std::numeric_limits<double>::infinity();
    time += time_over(piece.section, {start, end});
  }
  return time;
}

}  // namespace millwear::wear
