#include "meshgen/facet_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "mill/base/contract.h"
#include "mill/base/failure.h"
#include "mill/liner/profile_crossing.h"

namespace millwear::meshgen {
namespace {

/// How far a chord lies from the stretch of profile that it replaces [m].
struct ChordDeviation {
  double protrusion;  ///< to the side of the charge
  double recession;   ///< to the side of the steel, or past an end of the chord
};

/// The deviation of the chord from the first to the last of `nodes`, or nothing where it is above
/// `tolerance`. The distance to a chord is convex along a segment, so its maximum is at a node; and
/// as the stretch joins the chord's ends, every point of the chord is as near to the stretch.
std::optional<ChordDeviation> deviation_of_chord(std::span<const Eigen::Vector2d> nodes,
                                                 double tolerance) {
  const Eigen::Vector2d chord = nodes.back() - nodes.front();
  const Eigen::Vector2d towards_charge(-chord.y(), chord.x());
  ChordDeviation worst{0.0, 0.0};
  for (const Eigen::Vector2d& node : nodes.subspan(1, nodes.size() - 2)) {
    const Eigen::Vector2d from_start = node - nodes.front();
    const double along = std::clamp(from_start.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    const double distance = (from_start - along * chord).norm();
    if (!(distance <= tolerance)) {
      return std::nullopt;
    }
    double& side = from_start.dot(towards_charge) < 0.0 ? worst.protrusion : worst.recession;
    side = std::max(side, distance);
  }
  return worst;
}

struct BestOutline {
  int facets = std::numeric_limits<int>::max();
  double cost = 0.0;  ///< [m2]
  std::size_t previous = 0;

  bool operator<(const BestOutline& other) const {
    return facets != other.facets ? facets < other.facets : cost < other.cost;
  }
};

void refuse_crossing(const LinerProfile& profile, std::string_view subject,
                     std::string_view remedy) {
  const auto [first, second] = first_crossing(profile);
  if (first < 0) return;
  if (const auto twice = node_given_twice(profile, {first, second})) {
    throw InputError(fmt::format(
        "{} has a node twice: its nodes {} and {} are both ({:.6f}, {:.6f}) m, to a micrometre; "
        "delete one of the two",
        subject, twice->first, twice->second, profile.nodes[twice->first].x(),
        profile.nodes[twice->first].y()));
  }
  throw InputError(fmt::format(
      "{} crosses itself: segment {} (from {:.6g}, {:.6g} m) meets segment {} (from {:.6g}, {:.6g} "
      "m); {}",
      subject, first, profile.nodes[first].x(), profile.nodes[first].y(), second,
      profile.nodes[second].x(), profile.nodes[second].y(), remedy));
}

}  // namespace

std::vector<Eigen::Vector2d> dem_outline(const LinerProfile& profile, double tolerance) {
  expect(profile.nodes.size() >= 3, "a profile that is meshed has 3 nodes or more");
  expect(tolerance > 0.0, "a mesh tolerance is above 0 m");
  refuse_crossing(profile, "the liner profile", "a profile must run from edge to edge once");

  const std::span<const Eigen::Vector2d> nodes(profile.nodes);
  std::vector<BestOutline> best(nodes.size());
  best.front().facets = 0;
  for (std::size_t end = 1; end < nodes.size(); ++end) {
    for (std::size_t start = end; start-- > 0;) {
      const auto chord = deviation_of_chord(nodes.subspan(start, end - start + 1), tolerance);
      if (chord) {
        const double weighed = std::max(2.0 * chord->protrusion, chord->recession);
        best[end] = std::min(best[end],
                             {best[start].facets + 1, best[start].cost + weighed * weighed, start});
      }
    }
  }

  std::vector<Eigen::Vector2d> outline;
  for (std::size_t node = nodes.size() - 1; node > 0; node = best[node].previous) {
    outline.push_back(nodes[node]);
  }
  outline.push_back(nodes.front());
  std::ranges::reverse(outline);
  refuse_crossing({profile.sector, outline}, "the liner mesh's outline",
                  "a gap is narrower than the mesh tolerance: lower `dem.mesh_tolerance`");
  return outline;
}

std::vector<Eigen::Vector2d> with_facets_below(const std::vector<Eigen::Vector2d>& outline,
                                               double longest) {
  std::vector<Eigen::Vector2d> result{outline.front()};
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const Eigen::Vector2d facet = outline[i] - outline[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(facet.norm() / longest - 1e-9)));
    for (int part = 1; part < parts; ++part) {
      result.push_back(outline[i - 1] + facet * part / parts);
    }
    result.push_back(outline[i]);
  }
  return result;
}

std::vector<double> facet_lengths(const std::vector<Eigen::Vector2d>& outline) {
  std::vector<double> lengths(outline.size() - 1);
  std::transform(outline.begin(), outline.end() - 1, outline.begin() + 1, lengths.begin(),
                 [](const auto& a, const auto& b) { return (b - a).norm(); });
  return lengths;
}

}  // namespace millwear::meshgen
