#pragma once
#include <vector>

#include "mill/case.h"
#include "mill/liner_profile.h"
#include "wear/arc_curve.h"

namespace millwear::wear {

/// The profile after one geometry step.
struct GeometryStep {
  double duration;        ///< of milling [s]
  LinerProfile profile;   ///< at the step's end
  double removed_area;    ///< section of steel taken off in the step, with what fell off [m2]
  double accounted_area;  ///< the wear law's loss on the step's first profile, rate * duration [m2]
  double fallen_area;     ///< what lost its hold on the shell and fell off; part of removed [m2]
};

enum class EvolutionEnd {
  threshold_reached,  ///< enough worn: the load has to be computed anew
  height_limit,       ///< the lifter is worn out
  plate_limit,        ///< the plate is worn out
};

struct Evolution {
  std::vector<GeometryStep> steps;  ///< none where a limit was passed already
  EvolutionEnd end;
};

/// Wears the profile under one load, the 2006 paper's scheme: the load of the cycle's first profile
/// is applied, normal to the moving profile, again and again until the worn share of the lifter
/// passes a threshold.
///
/// `rate` is the depth rate [m/s] along `profile`. On a moved profile a place wears at the rate of
/// the nearest place of the cycle's first profile (next to a corner: the mean of both sides).
/// Every step takes threshold * new_lifter_area / steps_per_cycle [m2], which sets its duration.
/// The last step is shortened so that `height_limit` or `plate_limit` is met within 1e-6 m
/// (where a piece falls off and the height jumps over the limit: just below it).
/// First order in the step. Source: the 2006 paper, "Predicting the evolved lifter profile".
/// Throws InputError for settings not above zero, ResultRejected where the load wears nothing or
/// the profile cannot be moved.
[[nodiscard]] Evolution evolve(const LinerProfile& profile, const ArcCurve& rate,
                               double new_lifter_area, const CampaignSettings& settings);

}  // namespace millwear::wear
