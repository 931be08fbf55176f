#include "wear/surface/along_profile.h"

#include <algorithm>
#include <cmath>

namespace millwear::wear {

std::size_t segment_at(const std::vector<double>& lengths, double arc_length) {
  const auto above = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, arc_length);
  return static_cast<std::size_t>(above - lengths.begin()) - 1;
}

double on_one_pitch(double arc_length, double length) {
  return arc_length - length * std::floor(arc_length / length);
}

Eigen::Vector2d place_at(const LinerProfile& profile, const std::vector<double>& lengths,
                         double arc_length) {
  const double here = on_one_pitch(arc_length, lengths.back());
  const auto i = segment_at(lengths, here);
  const double share = (here - lengths[i]) / (lengths[i + 1] - lengths[i]);
  return profile.nodes[i] + share * (profile.nodes[i + 1] - profile.nodes[i]);
}

double turn_between(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

}  // namespace millwear::wear
