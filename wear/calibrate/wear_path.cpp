#include "wear/calibrate/wear_path.h"

#include <algorithm>
#include <cmath>

#include "mill/base/contract.h"
#include "mill/liner/profile_measures.h"
#include "wear/calibrate/angular_zones.h"
#include "wear/evolve/load_carrier.h"
#include "wear/evolve/loss_nodes.h"

namespace millwear::wear {
namespace {

constexpr double crest_share_of_height = 0.01;
constexpr double least_share_of_mean = 0.01;

/// A short stretch of a profile.
struct Stretch {
  Eigen::Vector2d middle;
  double length;
  Eigen::Index zone;
};

/// Between the neighbours of `loss_nodes`.
std::vector<Stretch> stretches_of(const LinerProfile& profile, double bin_width,
                                  Eigen::Index zones) {
  const auto nodes = loss_nodes(profile, bin_width, [](double) { return 0.0; });
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Eigen::Vector2d middle = 0.5 * (nodes[i].position + nodes[i + 1].position);
    stretches.push_back({middle, (nodes[i + 1].position - nodes[i].position).norm(),
                         zone_of(profile.sector, middle, zones)});
  }
  return stretches;
}

/// Depth rates of the campaign's law (column 0) and of every mechanism at the bins of a load.
Eigen::MatrixXd rates_of(const PathCycle& load) {
  Eigen::MatrixXd rates(load.campaign.values.size(),
                        static_cast<Eigen::Index>(load.mechanisms.size()) + 1);
  rates.col(0) = load.campaign.values;
  for (std::size_t m = 0; m < load.mechanisms.size(); ++m)
    rates.col(static_cast<Eigen::Index>(m) + 1) = load.mechanisms[m].values;
  return rates;
}

/// The same at each stretch of a liner: the mean of its two ends.
Eigen::MatrixXd rates_on(const LinerProfile& liner, const LoadCarrier& carrier,
                         const Eigen::MatrixXd& rates) {
  const Eigen::MatrixXd at_nodes = carrier.onto_nodes(liner) * rates;
  const Eigen::Index stretches = at_nodes.rows() - 1;
  return 0.5 * (at_nodes.topRows(stretches) + at_nodes.bottomRows(stretches));
}

/// A liner of the path under one load, or between two. Column 0 is the campaign's law.
struct LinerRates {
  Eigen::MatrixXd depths;      ///< by channel: mean depth per second of its places [m/s]
  Eigen::VectorXd lengths;     ///< of the profile in each zone [m]
  Eigen::RowVectorXd section;  ///< per second over the whole profile [m2/s]
};

LinerRates between(const LinerRates& first, const LinerRates& second, double share) {
  return {(1.0 - share) * first.depths + share * second.depths, first.lengths,
          (1.0 - share) * first.section + share * second.section};
}

/// Whether the campaign's law wears the places of a channel enough for its own loss to be shared.
bool worn_by_campaign(const Eigen::RowVectorXd& depth, const LinerRates& rates) {
  return depth[0] > least_share_of_mean * rates.section[0] / rates.lengths.sum();
}

/// Losses by channel from one liner to a later one.
Eigen::VectorXd lost_between(const LinerProfile& before, const LinerProfile& after,
                             Eigen::Index zones) {
  const PathChannels channels{zones};
  Eigen::VectorXd lost(channels.count());
  lost.head(zones) = steel_by_zone(before, zones) - steel_by_zone(after, zones);
  lost[channels.height()] = lifter_height(before) - lifter_height(after);
  lost[channels.plate()] = plate_thickness(before) - plate_thickness(after);
  return lost;
}

/// Which stretches make the crest of a profile, and which its thinnest plate.
struct Places {
  std::vector<bool> crest;
  std::vector<bool> plate;
};

Places places_on(const LinerProfile& profile, const std::vector<Stretch>& stretches, double band) {
  std::vector<double> radii(stretches.size());
  std::transform(stretches.begin(), stretches.end(), radii.begin(),
                 [&](const Stretch& stretch) { return radius_of(profile.sector, stretch.middle); });
  const auto [least, most] = std::minmax_element(radii.begin(), radii.end());
  Places places;
  for (const double radius : radii) {
    places.crest.push_back(radius <= *least + band);
    places.plate.push_back(radius >= *most - band);
  }
  return places;
}

Eigen::RowVectorXd mean_over(const std::vector<bool>& chosen, const std::vector<Stretch>& stretches,
                             const Eigen::MatrixXd& rates) {
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(rates.cols());
  double length = 0.0;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    if (!chosen[i]) continue;
    sum += stretches[i].length * rates.row(static_cast<Eigen::Index>(i));
    length += stretches[i].length;
  }
  return sum / length;
}

/// The path's cycles and what is looked up on them again and again.
class PathBuilder {
 public:
  PathBuilder(const std::vector<PathCycle>& cycles, PathPace pace, Eigen::Index zones)
      : cycles_(cycles), pace_(pace), zones_(zones) {
    for (const auto& cycle : cycles) {
      carriers_.emplace_back(cycle.liner, cycle.campaign.values.size());
      rates_.push_back(rates_of(cycle));
    }
    band_ = crest_share_of_height * std::abs(lifter_height(cycles.front().liner));
  }

  void add_cycle(std::size_t cycle, std::vector<PathPiece>& pieces) const {
    const auto& steps = cycles_[cycle].steps;
    double whole = 0.0;
    for (const auto& step : steps) whole += step.worn_section;
    double worn = 0.0;
    const LinerProfile* before = &cycles_[cycle].liner;
    for (const auto& step : steps) {
      const double end = worn + step.worn_section;
      pieces.push_back(piece_between(cycle, *before, step, worn / whole, end / whole));
      worn = end;
      before = &step.profile;
    }
  }

 private:
  /// What the load of a cycle does to a liner. Crest and plate are those of a later liner, whose
  /// places are the ones that were left.
  [[nodiscard]] LinerRates under(std::size_t load, const LinerProfile& liner,
                                 const LinerProfile& later) const {
    const LoadCarrier& carrier = carriers_[load];
    const auto stretches = stretches_of(liner, carrier.bin_width(), zones_);
    const Eigen::MatrixXd rates = rates_on(liner, carrier, rates_[load]);
    const PathChannels channels{zones_};
    LinerRates result{Eigen::MatrixXd::Zero(channels.count(), rates.cols()),
                      Eigen::VectorXd::Zero(zones_), Eigen::RowVectorXd::Zero(rates.cols())};
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const auto& stretch = stretches[i];
      result.lengths[stretch.zone] += stretch.length;
      result.depths.row(stretch.zone) += stretch.length * rates.row(static_cast<Eigen::Index>(i));
    }
    result.section = result.depths.topRows(zones_).colwise().sum();
    result.depths.topRows(zones_).array().colwise() /= result.lengths.array();
    const auto later_stretches = stretches_of(later, carrier.bin_width(), zones_);
    const Eigen::MatrixXd later_rates = rates_on(later, carrier, rates_[load]);
    const Places places = places_on(later, later_stretches, band_);
    result.depths.row(channels.height()) = mean_over(places.crest, later_stretches, later_rates);
    result.depths.row(channels.plate()) = mean_over(places.plate, later_stretches, later_rates);
    return result;
  }

  [[nodiscard]] LinerRates at(std::size_t cycle, const LinerProfile& liner,
                              const LinerProfile& later, double share) const {
    const LinerRates first = under(cycle, liner, later);
    if (cycle + 1 == cycles_.size()) return first;
    return between(first, under(cycle + 1, liner, later), share);
  }

  [[nodiscard]] PathPiece piece_between(std::size_t cycle, const LinerProfile& before,
                                        const PathStep& step, double start, double end) const {
    const Eigen::VectorXd lost = lost_between(before, step.profile, zones_) / step.worn_section;
    const auto rates = [&](const LinerProfile& liner, double share) {
      return path_rates(at(cycle, liner, step.profile, share), lost);
    };
    return {step.worn_section, rates(before, start), rates(step.profile, end)};
  }

  /// `lost` is what the campaign's liner loses in each channel for a unit of worn section.
  [[nodiscard]] PathRates path_rates(const LinerRates& rates, const Eigen::VectorXd& lost) const {
    const PathChannels channels{zones_};
    const Eigen::Index mechanisms = rates.depths.cols() - 1;
    const double section = rates.section[0];
    PathRates result{rates.section.tail(mechanisms).transpose(),
                     Eigen::MatrixXd(channels.count(), mechanisms)};
    for (Eigen::Index channel = 0; channel < channels.count(); ++channel) {
      const Eigen::RowVectorXd depth = rates.depths.row(channel);
      const double length = channel < zones_ ? rates.lengths[channel] : 1.0;
      result.losses.row(channel) =
          worn_by_campaign(depth, rates)
              ? (lost[channel] * section / depth[0] * depth.tail(mechanisms)).eval()
              : (length * depth.tail(mechanisms)).eval();
    }
    const Eigen::RowVectorXd crest = rates.depths.row(channels.height());
    if (pace_ == PathPace::height && worn_by_campaign(crest, rates))
      result.pace = (section / crest[0] * crest.tail(mechanisms)).transpose();
    return result;
  }

  const std::vector<PathCycle>& cycles_;
  PathPace pace_;
  Eigen::Index zones_;
  double band_;
  std::vector<LoadCarrier> carriers_;
  std::vector<Eigen::MatrixXd> rates_;
};

void check(const std::vector<PathCycle>& cycles, Eigen::Index zones) {
  expect(!cycles.empty() && !cycles.front().steps.empty() && zones >= 1,
         "a wear path has a cycle with its steps, and zones");
  for (const auto& cycle : cycles) {
    expect(!cycle.mechanisms.empty() && cycle.mechanisms.size() == cycles.front().mechanisms.size(),
           "a wear path has the same mechanisms in every cycle");
    for (const auto& step : cycle.steps)
      expect(step.worn_section > 0.0, "every step of a wear path takes steel");
  }
}

}  // namespace

WearPath wear_path(const std::vector<PathCycle>& cycles, PathPace pace, Eigen::Index zones) {
  check(cycles, zones);
  const PathBuilder builder(cycles, pace, zones);
  WearPath path{{zones}, {}, {}};
  const LinerProfile* last = &cycles.front().liner;
  for (std::size_t cycle = 0; cycle < cycles.size() && !cycles[cycle].steps.empty(); ++cycle) {
    builder.add_cycle(cycle, path.pieces);
    last = &cycles[cycle].steps.back().profile;
  }
  path.lost = lost_between(cycles.front().liner, *last, zones);
  return path;
}

}  // namespace millwear::wear
