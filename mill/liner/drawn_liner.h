#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "mill/base/length_unit.h"
#include "mill/liner/liner_profile.h"

namespace millwear {

/// The new liner as a drawing shows it.
struct DrawnLiner {
  std::filesystem::path file;
  std::optional<std::string> layer;  ///< that the profile is on
  std::optional<LengthUnit> unit;    ///< in place of the drawing's
  /// In the drawing's unit: the place on the new plate at the lifter's centre, with y towards the
  /// mill's axis. Without it the two ends of the curve lie on the plate.
  std::optional<Eigen::Vector2d> origin;
  bool is_mirrored;  ///< x runs against the direction of rotation
};

/// Reads a drawn liner into its sector. Throws InputError.
using ReadDrawnLiner = std::function<LinerProfile(const DrawnLiner&, const LinerSector&)>;

/// Throws InputError: this program reads no drawings.
[[nodiscard]] LinerProfile no_drawings(const DrawnLiner& drawn, const LinerSector& sector);

}  // namespace millwear
