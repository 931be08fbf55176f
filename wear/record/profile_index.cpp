#include "wear/record/profile_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mill/base/contract.h"

namespace millwear::wear {
ProfileIndex::ProfileIndex(const LinerProfile& profile, double reach, const IndexGrid& grid)
    : length_(0.0), grid_(grid) {
  expect(profile.nodes.size() >= 2, "a liner profile has at least two nodes");
  for (std::size_t i = 0; i + 1 < profile.nodes.size(); ++i) {
    const double length = (profile.nodes[i + 1] - profile.nodes[i]).norm();
    for (const int pitch : {-1, 0, 1}) {
      const auto start = shifted_by_pitches(profile.sector, profile.nodes[i], pitch);
      const auto end = shifted_by_pitches(profile.sector, profile.nodes[i + 1], pitch);
      const Eigen::Vector2d along = end - start;
      if (length > 0.0) {
        segments_.push_back({start, along, 1.0 / along.squaredNorm(), length, length_});
      }
    }
    length_ += length;
  }
  lay_grid(profile, reach);
}

void ProfileIndex::lay_grid(const LinerProfile& profile, double reach) {
  Eigen::Vector2d low = profile.nodes.front();
  Eigen::Vector2d high = low;
  for (const auto& node : profile.nodes) {
    low = low.cwiseMin(node);
    high = high.cwiseMax(node);
  }
  corner_ = low.array() - reach;
  const Eigen::Vector2d extent = (high - low).array() + 2.0 * reach;
  const Eigen::Vector2d cell(extent.x() / grid_.along_xi, extent.y() / grid_.along_eta);
  cells_per_metre_ = cell.cwiseInverse();

  std::vector<double> distances(segments_.size());
  for (int row = 0; row < grid_.along_eta; ++row) {
    for (int column = 0; column < grid_.along_xi; ++column) {
      first_candidate_.push_back(static_cast<std::uint32_t>(candidates_.size()));
      const Eigen::Vector2d centre =
          corner_ + Eigen::Vector2d((column + 0.5) * cell.x(), (row + 0.5) * cell.y());
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < segments_.size(); ++i) {
        distances[i] = compare(segments_[i], centre).squared_distance;
        least = std::min(least, distances[i]);
      }
      const double candidate_within = std::pow(std::sqrt(least) + 1.000001 * cell.norm(), 2);
      for (std::size_t i = 0; i < segments_.size(); ++i) {
        if (distances[i] <= candidate_within) candidates_.push_back(segments_[i]);
      }
    }
  }
  first_candidate_.push_back(static_cast<std::uint32_t>(candidates_.size()));
}

ProfileIndex::Nearest ProfileIndex::compare(const Segment& segment, const Eigen::Vector2d& point) {
  const Eigen::Vector2d offset = point - segment.start;
  const double share =
      std::clamp(offset.dot(segment.along) * segment.inverse_squared_length, 0.0, 1.0);
  return {(offset - share * segment.along).squaredNorm(),
          segment.arc_length + share * segment.length};
}

ProfilePlace ProfileIndex::nearest(const Eigen::Vector2d& point) const {
  const double column = (point.x() - corner_.x()) * cells_per_metre_.x();
  const double row = (point.y() - corner_.y()) * cells_per_metre_.y();
  const bool inside =
      column >= 0.0 && column < grid_.along_xi && row >= 0.0 && row < grid_.along_eta;
  const Segment* first = segments_.data();
  const Segment* last = first + segments_.size();
  if (inside) {
    const auto cell =
        static_cast<std::size_t>(static_cast<int>(row) * grid_.along_xi + static_cast<int>(column));
    first = candidates_.data() + first_candidate_[cell];
    last = candidates_.data() + first_candidate_[cell + 1];
  }
  Nearest best{std::numeric_limits<double>::infinity(), 0.0};
  for (; first != last; ++first) {
    const Nearest found = compare(*first, point);
    if (found.squared_distance < best.squared_distance) best = found;
  }
  return {best.arc_length, std::sqrt(best.squared_distance)};
}

}  // namespace millwear::wear
