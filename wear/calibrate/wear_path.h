#pragma once
#include <Eigen/Core>
#include <vector>

#include "mill/liner/liner_profile.h"
#include "wear/numerics/arc_curve.h"

namespace millwear::wear {

/// One geometry step of a campaign.
struct PathStep {
  double worn_section;   ///< steel that the law took in it, without what fell off [m2], > 0
  LinerProfile profile;  ///< at its end
};

/// One load of a campaign, and the steps taken on it.
struct PathCycle {
  LinerProfile liner;                ///< that the load was measured on
  ArcCurve campaign;                 ///< depth rate along it by the law the campaign ran with [m/s]
  std::vector<ArcCurve> mechanisms;  ///< by each mechanism of the law to calibrate [m/s]
  std::vector<PathStep> steps;       ///< none where the wear of the last load is not done
};

/// What moves a liner along the path, where the mechanisms wear it by other shares than the
/// campaign's law did: the steel worn off, or the height of the lifter.
enum class PathPace { section, height };

/// What is lost of a liner and can be measured: the section of steel in each zone [m2] (channels
/// 0 ... zones - 1, wear/calibrate/angular_zones.h), the lifter's height [m] and the plate's
/// thickness [m].
struct PathChannels {
  Eigen::Index zones;
  [[nodiscard]] Eigen::Index height() const { return zones; }
  [[nodiscard]] Eigen::Index plate() const { return zones + 1; }
  [[nodiscard]] Eigen::Index count() const { return zones + 2; }
};

/// Rates at one place of the path, of each mechanism with the coefficient of its case.
struct PathRates {
  Eigen::VectorXd pace;    ///< along the path [m2/s], size mechanisms
  Eigen::MatrixXd losses;  ///< channels x mechanisms [m2/s and m/s]
};

/// The path between two liners; the rates are linear in the worn section.
struct PathPiece {
  double section;  ///< worn between them [m2]
  PathRates start;
  PathRates end;
};

/// A campaign as a path of worn liners, with what every mechanism would take at each.
struct WearPath {
  PathChannels channels;
  std::vector<PathPiece> pieces;
  Eigen::VectorXd lost;  ///< by the last liner since new, by channel, from the shapes [m2 and m]
};

/// The path of a campaign, cycles in order from the new liner on.
///
/// A load wears a liner of its own cycle as `evolve` has it: a place wears at the rate of the
/// nearest place of the load's liner. Between two loads the rates are linear in the worn section;
/// after the last they stay. So times along the path are of second order in the worn section
/// between loads, whatever scheme the campaign kept.
///
/// What the campaign's liner lost in a channel c is shared out among the mechanisms,
///     r_mc = g_c q_0 w_mc / w_0c,      g_c = dL_c/dA of the campaign's liners,
/// q_0 the section that the campaign's law takes per second, w_mc and w_0c the mean depth rates of
/// the mechanism and of the campaign's law at the places that count: of a zone its profile; of the
/// height the crest (within 1 % of the new lifter's height of it, on the later liner); of the plate
/// likewise where it is thinnest. Where the campaign's law wears nothing there (w_0c below a
/// hundredth of its mean), r_mc = w_mc, in a zone times its length of profile. The pace along the
/// path is the section q_m that a mechanism takes; or, by height, q_0 w_m / w_0 of the crest, with
/// which the height on the path is the height worn.
///
/// There is a cycle with a step that takes steel, and a zone; every cycle has the same mechanisms
/// (std::logic_error).
[[nodiscard]] WearPath wear_path(const std::vector<PathCycle>& cycles, PathPace pace,
                                 Eigen::Index zones);

}  // namespace millwear::wear
