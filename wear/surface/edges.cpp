#include "wear/surface/edges.h"

#include <algorithm>
#include <cmath>

#include "mill/base/contract.h"
#include "wear/surface/along_profile.h"

namespace millwear::wear {
namespace {

/// A profile that is walked along over its pitch and the two beside it.
class Walk {
 public:
  explicit Walk(const LinerProfile& profile) : profile_(profile), lengths_(arc_lengths(profile)) {}

  [[nodiscard]] double length() const { return lengths_.back(); }
  [[nodiscard]] const std::vector<double>& nodes() const { return lengths_; }

  [[nodiscard]] Eigen::Vector2d place(double arc_length) const {
    const int pitch = static_cast<int>(std::floor(arc_length / length()));
    return shifted_by_pitches(profile_.sector, place_at(profile_, lengths_, arc_length), pitch);
  }

  /// > 0 on a crest.
  [[nodiscard]] double turn(double arc_length, double window) const {
    const Eigen::Vector2d here = place(arc_length);
    const Eigen::Vector2d before = here - place(arc_length - window);
    const Eigen::Vector2d after = place(arc_length + window) - here;
    return -turn_between(before, after);
  }

 private:
  const LinerProfile& profile_;
  std::vector<double> lengths_;
};

}  // namespace

std::vector<Edge> edges_of(const LinerProfile& profile, double window, double least_turn) {
  expect(window > 0.0 && least_turn > 0.0, "edges are looked for in a window, from a turn on");
  const Walk walk(profile);
  std::vector<Edge> turns;
  for (std::size_t i = 0; i + 1 < walk.nodes().size(); ++i) {
    const double turn = walk.turn(walk.nodes()[i], window);
    if (std::abs(turn) >= least_turn) turns.push_back({walk.nodes()[i], turn});
  }
  std::stable_sort(turns.begin(), turns.end(), [](const Edge& a, const Edge& b) {
    return std::abs(a.turn) > std::abs(b.turn);
  });
  std::vector<Edge> edges;
  for (const Edge& turn : turns) {
    const bool is_beside = std::any_of(edges.begin(), edges.end(), [&](const Edge& edge) {
      const double apart = std::abs(edge.arc_length - turn.arc_length);
      return std::min(apart, walk.length() - apart) < window;
    });
    if (!is_beside) edges.push_back(turn);
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.arc_length < b.arc_length; });
  return edges;
}

Eigen::VectorXd curvature_along(const LinerProfile& profile, Eigen::Index bins, double window) {
  expect(window > 0.0, "a curvature is looked for in a window");
  const Walk walk(profile);
  const double width = walk.length() / static_cast<double>(bins);
  return Eigen::VectorXd::NullaryExpr(bins, [&](Eigen::Index bin) {
    return walk.turn((static_cast<double>(bin) + 0.5) * width, window) / window;
  });
}

}  // namespace millwear::wear
