#include "wear/evolve/load_carrier.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace millwear::wear {
namespace {

constexpr double look_aside_share_of_bin = 1.0 / 40.0;
constexpr double reach_in_bins = 4.0;
/// Cosine of the angle up to which two places face the same way.
constexpr double same_way = 0.5;
constexpr double edge_from = std::numbers::pi / 7.2;

/// Direction of a profile at an arc length.
Eigen::Vector2d along_at(const LinerProfile& profile, const std::vector<double>& lengths,
                         double arc_length) {
  const auto i = segment_at(lengths, on_one_pitch(arc_length, lengths.back()));
  return (profile.nodes[i + 1] - profile.nodes[i]).normalized();
}

}  // namespace

LoadCarrier::LoadCarrier(const LinerProfile& first, Eigen::Index bins)
    : first_(first),
      lengths_(arc_lengths(first)),
      bins_(bins),
      width_(lengths_.back() / static_cast<double>(bins)),
      edges_(edges_of(first, width_, edge_from)),
      index_(first, reach_in_bins * width_, grid_for_hundreds) {}

LoadCarrier::Rows LoadCarrier::onto_nodes(const LinerProfile& worn) const {
  std::vector<double> lengths;
  const auto nodes = loss_nodes(worn, width_, [&](double arc_length) {
    lengths.push_back(arc_length);
    return 0.0;
  });
  lengths.push_back(lengths.front());
  return onto(worn, lengths);
}

LoadCarrier::Rows LoadCarrier::onto_bins(const LinerProfile& worn, Eigen::Index bins) const {
  const double width = arc_lengths(worn).back() / static_cast<double>(bins);
  std::vector<double> centres;
  for (Eigen::Index bin = 0; bin < bins; ++bin) {
    centres.push_back((static_cast<double>(bin) + 0.5) * width);
  }
  return onto(worn, centres);
}

LoadCarrier::Rows LoadCarrier::onto(const LinerProfile& worn,
                                    const std::vector<double>& places) const {
  const bool is_first = worn.nodes == first_.nodes;
  const auto lengths = arc_lengths(worn);
  const double aside = look_aside_share_of_bin * width_;
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](Eigen::Index row, double arc_length, double weight) {
    const auto between = bins_of(arc_length);
    entries.emplace_back(row, between.left, weight * (1.0 - between.share));
    entries.emplace_back(row, between.right, weight * between.share);
  };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (is_first) {
      add(row, places[i], 1.0);
      continue;
    }
    for (const double side : {-aside, aside}) {
      const double place = places[i] + side;
      add(row, origin_of(place_at(worn, lengths, place), along_at(worn, lengths, place)), 0.5);
    }
  }
  Rows rows(static_cast<Eigen::Index>(places.size()), bins_);
  rows.setFromTriplets(entries.begin(), entries.end());
  return rows;
}

double LoadCarrier::origin_of(const Eigen::Vector2d& place, const Eigen::Vector2d& along) const {
  const double nearest = index_.nearest(place).arc_length;
  if (along.dot(along_at(first_, lengths_, nearest)) >= same_way) return nearest;
  double least = std::numeric_limits<double>::infinity();
  double found = nearest;
  for (std::size_t i = 0; i + 1 < first_.nodes.size(); ++i)
    for (const int pitch : {-1, 0, 1}) {
      const Eigen::Vector2d from = shifted_by_pitches(first_.sector, first_.nodes[i], pitch);
      const Eigen::Vector2d way =
          shifted_by_pitches(first_.sector, first_.nodes[i + 1], pitch) - from;
      if (!(along.dot(way) >= same_way * way.norm()) || !(way.norm() > 0.0)) continue;
      const double share = std::clamp((place - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
      const double distance = (place - from - share * way).norm();
      if (distance >= least) continue;
      least = distance;
      found = lengths_[i] + share * way.norm();
    }
  return found;
}

BinsBeside LoadCarrier::bins_of(double arc_length) const {
  BinsBeside between = bins_beside(arc_length, width_, bins_);
  const double length = lengths_.back();
  const double left_centre = (static_cast<double>(between.left) + 0.5) * width_;
  const double way = between.share * width_;
  for (const Edge& edge : edges_) {
    const double to_edge = on_one_pitch(edge.arc_length - left_centre, length);
    if (to_edge < width_) between.share = way < to_edge ? 0.0 : 1.0;
  }
  return between;
}

}  // namespace millwear::wear
