#include "mill/liner/profile_crossing.h"

#include <algorithm>

namespace millwear {
namespace {

struct Segment {
  Eigen::Vector2d a;
  Eigen::Vector2d b;
  Eigen::Vector2d low;   ///< corner of the bounding box
  Eigen::Vector2d high;  ///< the opposite corner
};

std::vector<Segment> segments_of(const std::vector<Eigen::Vector2d>& nodes) {
  std::vector<Segment> segments;
  segments.reserve(nodes.size());
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Eigen::Vector2d& a = nodes[i];
    const Eigen::Vector2d& b = nodes[i + 1];
    segments.push_back({a, b, a.cwiseMin(b), a.cwiseMax(b)});
  }
  return segments;
}

bool boxes_touch(const Segment& s, const Segment& t) {
  return s.low.x() <= t.high.x() && t.low.x() <= s.high.x() && s.low.y() <= t.high.y() &&
         t.low.y() <= s.high.y();
}

/// > 0 where c lies to the left of the line from a to b.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Closed segments: touching counts. Segments whose boxes touch and that lie on one line meet.
bool meet(const Segment& s, const Segment& t) {
  return boxes_touch(s, t) && turn(s.a, s.b, t.a) * turn(s.a, s.b, t.b) <= 0.0 &&
         turn(t.a, t.b, s.a) * turn(t.a, t.b, s.b) <= 0.0;
}

/// `next` starts where `s` ends and runs straight back over it.
bool folds_back(const Segment& s, const Segment& next) {
  return turn(s.a, s.b, next.b) == 0.0 && (s.a - s.b).dot(next.b - s.b) > 0.0;
}

}  // namespace

std::pair<int, int> first_crossing(const LinerProfile& profile) {
  const std::vector<Segment> here = segments_of(profile.nodes);
  std::vector<Eigen::Vector2d> shifted = profile.nodes;
  std::transform(shifted.begin(), shifted.end(), shifted.begin(), [&](const Eigen::Vector2d& p) {
    return shifted_by_pitches(profile.sector, p, 1);
  });
  const std::vector<Segment> ahead = segments_of(shifted);

  const int count = static_cast<int>(here.size());
  for (int i = 0; i < count; ++i) {
    for (int j = i + 1; j < count; ++j) {
      if (j == i + 1 ? folds_back(here[i], here[j]) : meet(here[i], here[j])) {
        return {i, j};
      }
    }
    for (int j = 0; j < count; ++j) {
      const bool share_the_edge = i == count - 1 && j == 0;
      if (!share_the_edge && meet(here[i], ahead[j])) {
        return {i, j};
      }
    }
  }
  return {-1, -1};
}

std::optional<std::pair<int, int>> node_given_twice(const LinerProfile& profile,
                                                    std::pair<int, int> crossing) {
  for (const int a : {crossing.first, crossing.first + 1}) {
    for (const int b : {crossing.second, crossing.second + 1}) {
      if (a != b && (profile.nodes.at(a) - profile.nodes.at(b)).norm() <= same_point) {
        return std::pair(a, b);
      }
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> first_repeated_node(const std::vector<Eigen::Vector2d>& nodes) {
  const auto first = std::adjacent_find(nodes.begin(), nodes.end());
  if (first == nodes.end()) return std::nullopt;
  return static_cast<std::size_t>(first - nodes.begin()) + 1;
}

}  // namespace millwear
