#include "wear/evolve/loss_nodes.h"

#include <cmath>
#include <numbers>

#include "wear/surface/along_profile.h"

namespace millwear::wear {
namespace {

constexpr double widest_mitre = std::numbers::pi / 12.0;
/// A turn from which on two faces meet at an edge [rad].
constexpr double least_edge = std::numbers::pi / 12.0;
constexpr double aside_share_of_bin = 1.0 / 20.0;

/// The way from a node to the next.
struct Stretch {
  const LossNode* from;
  const LossNode* to;
  Eigen::Vector2d normal;  ///< into the steel
};

Eigen::Vector2d inward_normal(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Eigen::Vector2d along = (to - from).normalized();
  return {along.y(), -along.x()};
}

Eigen::Vector2d mitre(const Eigen::Vector2d& first, const Eigen::Vector2d& second) {
  return (first + second) / (1.0 + first.dot(second));
}

Polygon fan(const LossNode& node, const Eigen::Vector2d& first, double angle) {
  Polygon polygon{node.position};
  const int steps = static_cast<int>(std::ceil(angle / widest_mitre));
  for (int i = 0; i <= steps; ++i) {
    const double turn = angle * i / steps;
    const Eigen::Vector2d normal(std::cos(turn) * first.x() - std::sin(turn) * first.y(),
                                 std::sin(turn) * first.x() + std::cos(turn) * first.y());
    polygon.push_back(node.position + node.depth * normal);
  }
  return polygon;
}

}  // namespace

std::vector<LossNode> loss_nodes(const LinerProfile& profile, double resolution,
                                 const std::function<double(double)>& depth_at) {
  std::vector<LossNode> nodes;
  const double aside = aside_share_of_bin * resolution;
  double arc_length = 0.0;
  for (std::size_t i = 0; i + 1 < profile.nodes.size(); ++i) {
    const Eigen::Vector2d along = profile.nodes[i + 1] - profile.nodes[i];
    const double length = along.norm();
    const bool is_edge =
        i > 0 && turn_between(profile.nodes[i] - profile.nodes[i - 1], along) < -least_edge;
    if (is_edge) {
      nodes.push_back({profile.nodes[i], depth_at(arc_length - aside)});
      nodes.push_back({profile.nodes[i], depth_at(arc_length + aside)});
    }
    const int pieces = std::max(1, static_cast<int>(std::ceil(2.0 * length / resolution)));
    for (int piece = is_edge ? 1 : 0; piece < pieces; ++piece) {
      const double share = static_cast<double>(piece) / pieces;
      nodes.push_back({profile.nodes[i] + share * along, depth_at(arc_length + share * length)});
    }
    arc_length += length;
  }
  nodes.push_back({profile.nodes.back(), nodes.front().depth});
  return nodes;
}

double loss_area(const std::vector<LossNode>& nodes) {
  double area = 0.0;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    area += 0.5 * (nodes[i].depth + nodes[i + 1].depth) *
            (nodes[i + 1].position - nodes[i].position).norm();
  }
  return area;
}

std::vector<LossNode> scaled(std::vector<LossNode> nodes, double factor) {
  for (LossNode& node : nodes) node.depth *= factor;
  return nodes;
}

std::vector<LossNode> over_three_pitches(const LinerSector& sector,
                                         const std::vector<LossNode>& nodes) {
  std::vector<LossNode> all;
  for (const int pitch : {-1, 0, 1}) {
    for (std::size_t i = pitch == -1 ? 0 : 1; i < nodes.size(); ++i) {
      const bool kept = pitch == 0 || (pitch == -1 && i + 1 == nodes.size());
      const Eigen::Vector2d& here = pitch == 0 ? nodes[i].position : nodes.front().position;
      all.push_back(
          {kept ? here : shifted_by_pitches(sector, nodes[i].position, pitch), nodes[i].depth});
    }
  }
  return all;
}

std::vector<Polygon> swept_region(const std::vector<LossNode>& nodes) {
  std::vector<Polygon> region;
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    if (nodes[i].position != nodes[i + 1].position)
      stretches.push_back(
          {&nodes[i], &nodes[i + 1], inward_normal(nodes[i].position, nodes[i + 1].position)});
  std::vector<double> angles(stretches.size() + 1, 0.0);
  for (std::size_t i = 1; i < stretches.size(); ++i)
    angles[i] = turn_between(stretches[i - 1].normal, stretches[i].normal);
  const auto is_mitred = [&](std::size_t i) { return angles[i] > 0.0 && angles[i] < widest_mitre; };
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const auto& [here, next, normal] = stretches[i];
    if (angles[i] >= widest_mitre && here->depth > 0.0)
      region.push_back(fan(*here, stretches[i - 1].normal, angles[i]));
    if (!(here->depth > 0.0 || next->depth > 0.0)) continue;
    const Eigen::Vector2d from = is_mitred(i) ? mitre(stretches[i - 1].normal, normal) : normal;
    const Eigen::Vector2d to = is_mitred(i + 1) ? mitre(normal, stretches[i + 1].normal) : normal;
    region.push_back({here->position, next->position, next->position + next->depth * to,
                      here->position + here->depth * from});
  }
  return region;
}

}  // namespace millwear::wear
