#include "wear/surface/centre_path.h"

#include <algorithm>
#include <cmath>

#include "wear/surface/along_profile.h"
#include "wear/surface/closing.h"

namespace millwear::wear {
namespace {

bool lies_in(const Shadow& shadow, double arc_length, double length) {
  return (arc_length > shadow.from && arc_length < shadow.to) ||
         (arc_length + length > shadow.from && arc_length + length < shadow.to);
}

}  // namespace

Eigen::VectorXd centre_path(const LinerProfile& liner, Eigen::Index bins,
                            const RollingBalls& balls) {
  const auto& nodes = liner.nodes;
  const auto lengths = arc_lengths(liner);
  const double length = lengths.back();
  const double width = length / static_cast<double>(bins);
  Eigen::VectorXd path = Eigen::VectorXd::Ones(bins);
  Eigen::Vector2d last =
      nodes.front() - shifted_by_pitches(liner.sector, nodes[nodes.size() - 2], -1);
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Eigen::Vector2d along = nodes[i + 1] - nodes[i];
    if (!(along.norm() > 0.0)) continue;
    const auto bin = std::min(static_cast<Eigen::Index>(lengths[i] / width), bins - 1);
    path[bin] -= balls.mean * turn_between(last, along) / width;
    last = along;
  }
  path = path.cwiseMax(0.0);
  if (balls.smallest > 0.0)
    for (const Shadow& shadow : closing_of(liner, balls.smallest).shadows)
      for (Eigen::Index bin = 0; bin < bins; ++bin)
        if (lies_in(shadow, (static_cast<double>(bin) + 0.5) * width, length)) path[bin] = 0.0;
  return path;
}

}  // namespace millwear::wear
