#include "tests/verification/wear/synthetic_load.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace millwear::wear {
namespace {

/// Places of the load's parts [share of the profile].
constexpr double first_peak = 0.18;
constexpr double second_peak = 0.42;
constexpr double corner = 0.58;
constexpr double unloaded_from = 0.74;
constexpr double unloaded_to = 0.90;

constexpr int shifts = 8;  ///< places in a bin where a path may be centred
constexpr std::array<double, 3> lengths = {0.5, 1.0, 1.5};  ///< of paths, over their mean
constexpr int locked_balls = 12;

double bump(double place, double at, double width) {
  return std::exp(-0.5 * std::pow((place - at) / width, 2));
}

double density(double place) {
  if (place > unloaded_from && place < unloaded_to) return 0.0;
  const double face = place < corner ? 0.0 : 0.7 * std::exp((corner - place) / 0.04);
  return 0.4 + 1.6 * bump(place, first_peak, 0.05) + 1.2 * bump(place, second_peak, 0.035) + face;
}

/// Share of the collisions that are centred in every bin.
Eigen::VectorXd centres_of(const SyntheticMill& mill) {
  const auto n = static_cast<double>(mill.bins);
  Eigen::VectorXd share = Eigen::VectorXd::NullaryExpr(
      mill.bins, [&](auto bin) { return density((static_cast<double>(bin) + 0.5) / n); });
  share[static_cast<Eigen::Index>(corner * n)] += mill.corner_share * share.sum();
  return share / share.sum();
}

double centre_in(Eigen::Index bin, int shift) {
  return static_cast<double>(bin) + (shift + 0.5) / shifts;
}

/// Adds the energy of a path of `length` bins.
void spread(Eigen::Ref<Eigen::VectorXd> onto, double centre, double length, double energy) {
  const Eigen::Index n = onto.size();
  const double from = centre - 0.5 * length;
  const double to = centre + 0.5 * length;
  for (auto bin = static_cast<Eigen::Index>(std::floor(from)); static_cast<double>(bin) < to;
       ++bin) {
    const auto left = static_cast<double>(bin);
    onto[(bin + n) % n] += energy * (std::min(to, left + 1.0) - std::max(from, left)) / length;
  }
}

Eigen::VectorXd truth_of(const SyntheticMill& mill, const Eigen::VectorXd& centres) {
  Eigen::VectorXd truth = Eigen::VectorXd::Zero(mill.bins);
  for (Eigen::Index bin = 0; bin < mill.bins; ++bin)
    for (int shift = 0; shift < shifts; ++shift)
      for (const double length : lengths)
        spread(truth, centre_in(bin, shift), length * mill.footprint,
               centres[bin] / (shifts * lengths.size()));
  return truth / truth.mean();
}

Eigen::Index top_of(const Eigen::VectorXd& truth, double from, double to) {
  const auto bins = static_cast<double>(truth.size());
  const auto first = static_cast<Eigen::Index>(from * bins);
  Eigen::Index best = 0;
  truth.segment(first, static_cast<Eigen::Index>((to - from) * bins)).maxCoeff(&best);
  return first + best;
}

}  // namespace

SyntheticLoad measured(const SyntheticMill& mill, unsigned seed) {
  const Eigen::VectorXd centres = centres_of(mill);
  const auto bins = static_cast<double>(mill.bins);
  Eigen::MatrixXd by_block = Eigen::MatrixXd::Zero(mill.bins, mill.blocks);
  std::mt19937_64 random(seed);
  std::discrete_distribution<Eigen::Index> place(centres.begin(), centres.end());
  std::uniform_int_distribution<int> shift(0, shifts - 1);
  std::uniform_int_distribution<std::size_t> length(0, lengths.size() - 1);
  std::lognormal_distribution<double> energy(-0.5 * std::pow(mill.energy_spread, 2),
                                             mill.energy_spread);
  std::poisson_distribution<int> events(mill.events_in_block * (1.0 - mill.locked_share));
  for (Eigen::Index block = 0; block < mill.blocks; ++block)
    for (int left = events(random); left > 0; --left) {
      const double centre = centre_in(place(random), shift(random));
      spread(by_block.col(block), centre, mill.footprint * lengths.at(length(random)),
             energy(random) * bins / mill.events_in_block);
    }
  Eigen::VectorXd locked = Eigen::VectorXd::Zero(mill.bins);
  for (int ball = 0; mill.locked_share > 0.0 && ball < locked_balls; ++ball)
    spread(locked, centre_in(place(random), shifts / 2), mill.locked_footprint,
           mill.locked_share * bins / locked_balls);
  for (Eigen::Index block = 0; mill.locked_share > 0.0 && block < mill.blocks; ++block)
    by_block.col(block) += energy(random) * locked;
  const Eigen::VectorXd truth = truth_of(mill, centres);
  return {Eigen::VectorXd::LinSpaced(mill.bins + 1, 0.0, bins),
          truth,
          by_block.rowwise().mean(),
          by_block,
          {top_of(truth, 0.0, 0.3), top_of(truth, 0.3, 0.5), top_of(truth, 0.55, 0.65)}};
}

}  // namespace millwear::wear
