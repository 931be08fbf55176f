#include "wear/evolve/load_carrier.h"

#include <algorithm>
#include <cmath>

namespace millwear::wear {
namespace {

constexpr double look_aside_share_of_bin = 1.0 / 40.0;
constexpr double reach_in_bins = 4.0;

}  // namespace

LoadCarrier::LoadCarrier(const LinerProfile& first, Eigen::Index bins)
    : first_(first),
      bins_(bins),
      width_(arc_lengths(first).back() / static_cast<double>(bins)),
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
    const auto between = bins_beside(arc_length, width_, bins_);
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
      add(row, index_.nearest(place_at(worn, lengths, places[i] + side)).arc_length, 0.5);
    }
  }
  Rows rows(static_cast<Eigen::Index>(places.size()), bins_);
  rows.setFromTriplets(entries.begin(), entries.end());
  return rows;
}

Eigen::Vector2d place_at(const LinerProfile& profile, const std::vector<double>& lengths,
                         double arc_length) {
  const double length = lengths.back();
  const double wrapped = arc_length - length * std::floor(arc_length / length);
  const auto above = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, wrapped);
  const auto i = static_cast<std::size_t>(above - lengths.begin());
  const double share = (wrapped - lengths[i - 1]) / (lengths[i] - lengths[i - 1]);
  return profile.nodes[i - 1] + share * (profile.nodes[i] - profile.nodes[i - 1]);
}

}  // namespace millwear::wear
