#include "wear/calibration.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "sample_profiles.h"
#include "wear/angular_zones.h"
#include "wear/evolution.h"
#include "wear/path_prediction.h"
#include "wear/wear_law.h"

namespace millwear::wear {
namespace {

constexpr Eigen::Index bins = 120;
constexpr Eigen::Index zones = 12;
constexpr double hour = 3600.0;
constexpr double year = 8766.0 * hour;

/// A charge of one class.
Charge one_class() { return {{{0, 0.05, 100}}, {}, 0.4, 0.0}; }

/// What wears the synthetic liner: sliding on the leading face and the top, more as the lifter gets
/// lower; impacts on top, trailing face and plate, fewer as it gets lower.
enum class Pattern { apart, alike };

double sliding_at(const LinerProfile& profile, const Eigen::Vector2d& place) {
  const double lower = 1.0 - lifter_height(profile) / 0.1;
  const double leading = std::exp(-std::pow((place.x() - 0.06) / 0.06, 2));
  return (1.0 + 1.5 * lower) * (0.15 + leading);
}

double impact_at(const LinerProfile& profile, const Eigen::Vector2d& place) {
  const double lower = 1.0 - lifter_height(profile) / 0.1;
  const double trailing = std::exp(-std::pow((place.x() + 0.08) / 0.09, 2));
  return (1.0 - 0.5 * lower) * (0.2 + trailing);
}

/// A load whose depth rates at k = 1e-12 1/Pa are the patterns times 0.1 m a year.
WallLoad load_on(const LinerProfile& profile, Pattern pattern) {
  const auto lengths = arc_lengths(profile);
  WallLoad load{};
  load.slice_length = 0.2;
  load.rows = profile.sector.rows;
  load.duration = 2.0;
  load.bin_edges = Eigen::VectorXd::LinSpaced(bins + 1, 0.0, lengths.back());
  load.class_count = 1;
  load.block_count = 1;
  load.values.fill(Eigen::MatrixXd::Zero(bins, 1));
  const double energy = 0.1 / year * load.bin_area()[0] * load.rows * load.duration / 1e-12;
  std::size_t segment = 0;
  for (Eigen::Index bin = 0; bin < bins; ++bin) {
    const double at = 0.5 * (load.bin_edges[bin] + load.bin_edges[bin + 1]);
    while (lengths[segment + 1] < at) ++segment;
    const double share = (at - lengths[segment]) / (lengths[segment + 1] - lengths[segment]);
    const Eigen::Vector2d place =
        (1.0 - share) * profile.nodes[segment] + share * profile.nodes[segment + 1];
    const double sliding = sliding_at(profile, place);
    load.values[index_of(Measure::sliding_work)](bin, 0) = energy * sliding;
    load.values[index_of(Measure::excess_energy)](bin, 0) =
        energy * (pattern == Pattern::apart ? impact_at(profile, place) : 0.7 * sliding);
  }
  return load;
}

ArcCurve rate_of(const std::vector<WearMechanism>& mechanisms, const WallLoad& load) {
  ArcCurve curve{load.bin_edges, Eigen::VectorXd::Zero(bins)};
  for (const auto& mechanism : mechanisms)
    curve.values += depth_rate(weights_of(mechanism, one_class()), load);
  return curve;
}

std::vector<WearMechanism> law(double sliding, double impact) {
  return {{WearLaw::archard, sliding * 1e-12}, {WearLaw::excess_energy, impact * 1e-12}};
}

std::vector<GeometryStep> worn(const LinerProfile& profile, const ArcCurve& rate, double threshold,
                               int steps, double height_limit) {
  return evolve(std::vector<TimedLoad>{{0.0, profile, rate}}, lifter_area(square_lifter()),
                {threshold, steps, height_limit, 0.001, 1000})
      .steps;
}

/// A liner of the truth, `time` seconds after new.
struct TrueLiner {
  double time;
  LinerProfile profile;
};

/// The life of the liner in small steps, each under its own load.
std::vector<TrueLiner> true_life(const std::vector<WearMechanism>& mechanisms, Pattern pattern,
                                 double lowest) {
  std::vector<TrueLiner> life{{0.0, square_lifter()}};
  while (true) {
    const LinerProfile& now = life.back().profile;
    const auto steps = worn(now, rate_of(mechanisms, load_on(now, pattern)), 0.01, 1, lowest);
    if (steps.empty()) return life;
    life.push_back({life.back().time + steps.front().duration, steps.front().profile});
  }
}

/// A campaign with few loads and its own coefficients, to a lower lifter than any reading.
std::vector<PathCycle> campaign(const std::vector<WearMechanism>& run,
                                const std::vector<WearMechanism>& calibrated, Pattern pattern,
                                double threshold) {
  std::vector<PathCycle> cycles;
  LinerProfile liner = square_lifter();
  while (true) {
    const WallLoad load = load_on(liner, pattern);
    PathCycle cycle{liner, rate_of(run, load), {}, {}};
    for (const auto& mechanism : calibrated) cycle.mechanisms.push_back(rate_of({mechanism}, load));
    for (auto& step : worn(liner, cycle.campaign, threshold, 5, 0.015))
      cycle.steps.push_back({step.accounted_area, std::move(step.profile)});
    cycles.push_back(cycle);
    if (cycle.steps.empty()) return cycles;
    liner = cycle.steps.back().profile;
  }
}

double height_at(const std::vector<TrueLiner>& life, double time) {
  std::size_t i = 1;
  while (i + 1 < life.size() && life[i].time < time) ++i;
  const double share = (time - life[i - 1].time) / (life[i].time - life[i - 1].time);
  return (1.0 - share) * lifter_height(life[i - 1].profile) +
         share * lifter_height(life[i].profile);
}

/// Heights at even dates over the life, with an error of `error` [m].
std::vector<LossObservation> heights(const std::vector<TrueLiner>& life, std::size_t count,
                                     double error, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, error);
  std::vector<LossObservation> readings;
  for (std::size_t i = 0; i < count; ++i) {
    const double time = life.back().time * static_cast<double>(i + 1) / static_cast<double>(count);
    const double lost = lifter_height(square_lifter()) - height_at(life, time);
    readings.push_back({i, time, zones, lost + noise(random), error});
  }
  return readings;
}

/// Sections lost in every zone, as profiles of error `error` [m] would show them.
std::vector<LossObservation> profiles(const std::vector<TrueLiner>& life, std::size_t count,
                                      double error, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  const Eigen::VectorXd fresh = steel_by_zone(square_lifter(), zones);
  std::vector<LossObservation> readings;
  for (std::size_t i = 0; i < count; ++i) {
    const TrueLiner& liner = life[(life.size() - 1) * (i + 1) / count];
    const Eigen::VectorXd lost = fresh - steel_by_zone(liner.profile, zones);
    const Eigen::VectorXd errors = error * length_by_zone(liner.profile, zones);
    for (Eigen::Index zone = 0; zone < zones; ++zone)
      readings.push_back({i, liner.time, zone, lost[zone] + errors[zone] * noise(random),
                          errors[zone]});
  }
  return readings;
}

const std::vector<TrueLiner>& true_mill() {
  static const auto life = true_life(law(1.6, 0.6), Pattern::apart, 0.03);
  return life;
}

WearPath coarse_path(PathPace pace) {
  static const auto cycles = campaign(law(1.0, 1.0), law(1.0, 1.0), Pattern::apart, 0.1);
  return wear_path(cycles, pace, zones);
}

void print(const char* what, const Calibration& c) {
  std::cout << what << " f " << c.fit.factors.transpose() << " +- " << c.errors.transpose()
            << " chi2 " << c.fit.chi_square << " / " << c.freedom << " cond " << c.condition
            << " rise " << c.rise_without.transpose() << " alike " << c.alike.size();
  if (!c.alike.empty())
    std::cout << " rho " << c.alike[0].correlation << " ex " << c.alike[0].exchangeable << " lost "
              << c.alike[0].lost << " +- " << c.alike[0].error;
  std::cout << "\n";
}

TEST(Explore, All) {
  std::cout << true_mill().size() << " states, " << true_mill().back().time / hour << " h\n";
  for (double e : {1e-5, 1e-4, 5e-4}) {
    print("heights by height ", calibrate(coarse_path(PathPace::height), heights(true_mill(), 10, e, 1)));
    print("heights by section", calibrate(coarse_path(PathPace::section), heights(true_mill(), 10, e, 1)));
    print("profiles          ", calibrate(coarse_path(PathPace::section), profiles(true_mill(), 6, e, 1)));
  }
  for (double t : {0.2, 0.1, 0.05, 0.025}) {
    const auto cycles = campaign(law(1.6, 0.6), law(1.0, 1.0), Pattern::apart, t);
    std::cout << t << " " << cycles.size() << "\n";
    print("same law: heights by height ", calibrate(wear_path(cycles, PathPace::height, zones), heights(true_mill(), 10, 1e-5, 1)));
    print("same law: heights by section", calibrate(wear_path(cycles, PathPace::section, zones), heights(true_mill(), 10, 1e-5, 1)));
    print("same law: profiles          ", calibrate(wear_path(cycles, PathPace::section, zones), profiles(true_mill(), 6, 1e-5, 1)));
  }
}

}  // namespace
}  // namespace millwear::wear
