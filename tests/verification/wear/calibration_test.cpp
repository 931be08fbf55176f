#include "wear/calibrate/calibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mill/liner/profile_measures.h"
#include "tests/support/sample_profiles.h"
#include "wear/calibrate/angular_zones.h"
#include "wear/calibrate/path_prediction.h"
#include "wear/evolve/evolution.h"
#include "wear/rate/wear_law.h"

namespace millwear::wear {
namespace {

constexpr Eigen::Index bins = 120;
constexpr Eigen::Index zones = 12;
constexpr double hour = 3600.0;
constexpr double year = 8766.0 * hour;

/// All particles are of one class.
const std::vector<ParticleClass> one_class = {{0, 0.05, 100}};

/// What wears the synthetic liner: sliding on the leading face and the top, more as the lifter gets
/// lower; impacts on top, trailing face and plate, fewer as it gets lower.
/// `alike`: impacts where there is sliding. `even`: the same everywhere, whatever the height.
/// `growing`: the same everywhere, more as the lifter gets lower.
enum class Pattern { apart, alike, even, growing };

double sliding_at(const LinerProfile& profile, const Eigen::Vector2d& place, Pattern pattern) {
  const double lower = 1.0 - lifter_height(profile) / 0.1;
  if (pattern == Pattern::even) return 1.0;
  if (pattern == Pattern::growing) return 1.0 + 3.0 * lower;
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
    const double sliding = sliding_at(profile, place, pattern);
    load.values[index_of(Measure::sliding_work)](bin, 0) = energy * sliding;
    load.values[index_of(Measure::excess_energy)](bin, 0) =
        energy * (pattern == Pattern::apart ? impact_at(profile, place) : 0.7 * sliding);
  }
  return load;
}

ArcCurve rate_of(const std::vector<WearMechanism>& mechanisms, const WallLoad& load) {
  ArcCurve curve{load.bin_edges, Eigen::VectorXd::Zero(bins)};
  for (const auto& mechanism : mechanisms)
    curve.values += depth_rate(weights_of(mechanism, one_class), load);
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
    for (const auto& mechanism : calibrated)
      if (mechanism.specific_wear_rate > 0.0)
        cycle.mechanisms.push_back(rate_of({mechanism}, load));
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
      readings.push_back(
          {i, liner.time, zone, lost[zone] + errors[zone] * noise(random), errors[zone]});
  }
  return readings;
}

constexpr double sliding = 1.6;
constexpr double impact = 0.6;
const Eigen::Vector2d truth(sliding, impact);

const std::vector<TrueLiner>& true_mill() {
  static const auto life = true_life(law(sliding, impact), Pattern::apart, 0.03);
  return life;
}

/// The path of a campaign with ten loads or so; factors are of coefficients of 1e-12 1/Pa.
WearPath path_of_campaign(const Eigen::Vector2d& run) {
  return wear_path(campaign(law(run[0], run[1]), law(1.0, 1.0), Pattern::apart, 0.1),
                   PathPace::section, zones);
}

/// The path of a campaign with coefficients that are wrong by 0.6 and 1.7.
const WearPath& wrong_path() {
  static const WearPath path = path_of_campaign({1.0, 1.0});
  return path;
}

/// Differences to the truth in standard errors.
Eigen::Array2d in_errors(const Calibration& found) {
  return (found.fit.factors - truth).array() / found.errors.array();
}

// The other campaign wears other shapes; a gauge that is good to 2 mm does not see it.
TEST(Calibration, FindsTheCoefficientsFromProfilesAlongAnotherCampaign) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const Calibration found = calibrate(wrong_path(), profiles(true_mill(), 6, 2e-3, seed));
    EXPECT_LT(in_errors(found).abs().maxCoeff(), 3.0) << found.fit.factors.transpose();
    EXPECT_LT(found.errors[0], 0.1);
    EXPECT_LT(found.errors[1], 0.1);
    EXPECT_TRUE(found.alike.empty());
  }
}

// Two profiles tell the mechanisms apart, ten heights the time.
TEST(Calibration, FindsTheCoefficientsFromHeightsAndProfiles) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    auto readings = profiles(true_mill(), 2, 2e-3, seed);
    for (auto& seen : heights(true_mill(), 10, 2e-3, 100 + seed)) {
      seen.reading += 2;
      readings.push_back(seen);
    }
    EXPECT_LT(in_errors(calibrate(wrong_path(), readings)).abs().maxCoeff(), 3.0);
  }
}

// Exact profiles along the wrong campaign leave 3 %, those along one that is run with what they
// gave half a per cent: shapes and loads are then those of the truth, and the rest is of the steps.
TEST(Calibration, ConvergesAsTheCampaignIsRunAgain) {
  const auto readings = profiles(true_mill(), 6, 1e-6, 1);
  const Eigen::VectorXd first = calibrate(wrong_path(), readings).fit.factors;
  const Eigen::VectorXd second = calibrate(path_of_campaign(first), readings).fit.factors;
  const double wrong = ((first - truth).array() / truth.array()).abs().maxCoeff();
  EXPECT_LT(wrong, 0.04);
  EXPECT_LT(((second - truth).array() / truth.array()).abs().maxCoeff(), 0.005);
}

// Forty seeds, two factors: the mean of normalised errors is 0 within 3 / sqrt(40), their variance
// 1 within 3 sqrt(2 / 40).
TEST(Calibration, GivesHonestErrors) {
  const WearPath path = path_of_campaign({1.55, 0.62});
  constexpr int seeds = 40;
  Eigen::Array2d sum = Eigen::Array2d::Zero();
  Eigen::Array2d squares = Eigen::Array2d::Zero();
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const Eigen::Array2d errors = in_errors(calibrate(path, profiles(true_mill(), 6, 1e-3, seed)));
    sum += errors;
    squares += errors.square();
  }
  const Eigen::Array2d variance = squares / seeds;
  EXPECT_LT((sum / seeds).abs().maxCoeff(), 3.0 / std::sqrt(seeds));
  EXPECT_LT((variance - 1.0).abs().maxCoeff(), 3.0 * std::sqrt(2.0 / seeds)) << variance;
}

// Impacts of 0.7 times the sliding's energy everywhere: only f1 + 0.7 f2 is known.
TEST(Calibration, SaysWhatCannotBeToldApart) {
  const auto life = true_life(law(sliding, impact), Pattern::alike, 0.06);
  const WearPath path = wear_path(campaign(law(1.0, 1.0), law(1.0, 1.0), Pattern::alike, 0.1),
                                  PathPace::section, zones);
  const Calibration found = calibrate(path, profiles(life, 4, 1e-3, 1));
  EXPECT_NEAR(found.fit.factors[0] + 0.7 * found.fit.factors[1], sliding + 0.7 * impact, 0.05);
  ASSERT_EQ(found.alike.size(), 1U);
  EXPECT_TRUE(found.alike[0].exchangeable);
  const double lost = steel_area(square_lifter()) - steel_area(life.back().profile);
  EXPECT_NEAR(found.alike[0].lost, lost, 4.0 * found.alike[0].error);
}

/// Root mean squares of what is predicted of a reading from all others.
struct LeftOut {
  double fit;
  double line;
};

LeftOut left_out(const WearPath& path, const std::vector<LossObservation>& readings) {
  const auto factors = factors_without_each(path, readings, calibrate(path, readings).fit.factors);
  LeftOut sum{0.0, 0.0};
  for (const auto& seen : readings) {
    const double fitted = loss_at(path, *factors[seen.reading], seen.time).lost[seen.channel];
    const double line =
        straight_line(readings, path.channels.count(), seen.reading)[seen.channel] * seen.time;
    sum.fit += std::pow(fitted - seen.lost, 2);
    sum.line += std::pow(line - seen.lost, 2);
  }
  const auto count = static_cast<double>(readings.size());
  return {std::sqrt(sum.fit / count), std::sqrt(sum.line / count)};
}

WearPath path_by_height(Pattern pattern) {
  return wear_path(campaign(law(1.0, 0.0), law(1.0, 0.0), pattern, 0.1), PathPace::height, zones);
}

std::vector<LossObservation> eight_heights(Pattern pattern) {
  return heights(true_life(law(sliding, 0.0), pattern, 0.055), 8, 5e-4, 3);
}

// The rate grows 2.3 times as the lifter falls: a straight line does not see it.
TEST(Calibration, PredictsAcceleratingWearBetterThanALine) {
  const auto readings = eight_heights(Pattern::growing);
  const LeftOut rms = left_out(path_by_height(Pattern::growing), readings);
  EXPECT_LT(rms.fit, 1e-3);
  EXPECT_GT(rms.line, 3.0 * rms.fit);
}

TEST(Calibration, IsNoBetterThanALineWhereWearIsLinear) {
  const LeftOut rms = left_out(path_by_height(Pattern::even), eight_heights(Pattern::even));
  EXPECT_LT(rms.fit, 1e-3);
  EXPECT_NEAR(rms.line / rms.fit, 1.0, 0.1);
}

}  // namespace
}  // namespace millwear::wear
