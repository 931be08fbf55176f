#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "mill/liner/liner_profile.h"

namespace millwear::wear {

/// A place on a profile, and how far away from it the point lies that was asked for.
struct ProfilePlace {
  double arc_length;  ///< from the profile's first node [m], 0 ... length
  double distance;    ///< [m], >= 0
};

/// Cells of the grid that a `ProfileIndex` lays. Laying it takes time with their number, asking for
/// places takes less the more there are: many for a million questions, few for a few hundred.
struct IndexGrid {
  int along_xi = 96;
  int along_eta = 64;
};
inline constexpr IndexGrid grid_for_hundreds{24, 16};

/// Finds the nearest place on a profile and on its images on the two neighbouring pitches, whose
/// arc length is that of the place they are images of.
///
/// A grid lies over the profile and `reach` around it. Each cell knows the segments that can be
/// nearest to any of its points (those not farther from its centre than the nearest one plus the
/// cell's diagonal), so the answer is exact; points outside the grid are compared with all.
class ProfileIndex {
 public:
  /// `reach` [m], > 0. The profile has at least two nodes (std::logic_error).
  ProfileIndex(const LinerProfile& profile, double reach, const IndexGrid& grid = {});

  [[nodiscard]] ProfilePlace nearest(const Eigen::Vector2d& point) const;

  /// Length of the profile [m].
  [[nodiscard]] double length() const { return length_; }

 private:
  struct Segment {
    Eigen::Vector2d start;
    Eigen::Vector2d along;
    double inverse_squared_length;
    double length;
    double arc_length;
  };
  struct Nearest {
    double squared_distance;
    double arc_length;
  };

  [[nodiscard]] static Nearest compare(const Segment& segment, const Eigen::Vector2d& point);
  void lay_grid(const LinerProfile& profile, double reach);

  double length_;
  IndexGrid grid_;
  std::vector<Segment> segments_;
  Eigen::Vector2d corner_;
  Eigen::Vector2d cells_per_metre_;
  std::vector<std::uint32_t> first_candidate_;
  std::vector<Segment> candidates_;
};

}  // namespace millwear::wear
