#pragma once
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "mill/case/campaign_settings.h"
#include "mill/liner/liner_profile.h"
#include "wear/evolve/load_in_time.h"

namespace millwear::wear {

/// The profile after one geometry step.
struct GeometryStep {
  double duration;        ///< of milling [s]
  LinerProfile profile;   ///< at the step's end
  double removed_area;    ///< section of steel taken off in the step, with what fell off [m2]
  double accounted_area;  ///< the load's loss on the step's first profile, rate * duration [m2]
  double fallen_area;     ///< what lost its hold on the shell and fell off; part of removed [m2]
};

enum class EvolutionEnd {
  load_spent,    ///< the load has to be measured anew
  height_limit,  ///< the lifter is worn out
  plate_limit,   ///< the plate is worn out
  time_reached,  ///< the longest time is over
};

/// As in files, e.g. `load_spent`.
[[nodiscard]] std::string_view name_of(EvolutionEnd end);

struct Evolution {
  std::vector<GeometryStep> steps;  ///< none where a limit was passed already
  EvolutionEnd end;
};

/// How near to its limit a campaign ends [m].
inline constexpr double limit_within = 1e-6;

/// Wears the liner of the newest load until the load has to be measured anew, a limit is met, or
/// `longest` [s] is over.
///
/// Scheme `threshold`, the 2006 paper's: the newest load is applied, normal to the moving profile,
/// again and again until `threshold` of the new lifter's section is worn. Each of `steps_per_cycle`
/// geometry steps takes the same section, which sets its duration. First order.
/// Scheme `adaptive`: the load goes on changing as it did between the last two (`LoadInTime`, at
/// the middle of each geometry step) for `time_to_next_load`, in `steps_per_cycle` even times.
/// Second order.
///
/// `loads` are all that were measured on this liner since it was new or the mill's rotation was
/// reversed, at least one; the last three count. On a moved profile a place wears at the rate of
/// the nearest place of the liner that the newest load was measured on (`LoadCarrier`).
/// The last step is shortened so that `height_limit` or `plate_limit` is met within `limit_within`
/// (where a piece falls off and the height jumps over the limit: just below it). A step that is
/// more than the load can take is halved until it is not; where the places are gone that the load
/// wore, it is spent.
/// Source: the 2006 paper, "Predicting the evolved lifter profile"; docs/physics.md.
/// Settings and times are above zero (std::logic_error). Throws ResultRejected where the load wears
/// nothing or the profile cannot be moved.
[[nodiscard]] Evolution evolve(std::span<const TimedLoad> loads, double new_lifter_area,
                               const CampaignSettings& settings,
                               double longest = std::numeric_limits<double>::infinity());

}  // namespace millwear::wear
