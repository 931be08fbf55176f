#pragma once
#include <span>

#include "mill/case/campaign_settings.h"
#include "wear/evolve/load_in_time.h"

namespace millwear::wear {

/// What a measured load says of the step of time that led to it.
struct StepError {
  double worn_share;  ///< the share of the new lifter's section that the step wore
  double misplaced;   ///< ... that it wore where the new load would not have, beyond noise
};

/// The error of the step between the last two of `loads`, taken from the newest: with d the
/// difference between its rate and the one that was extrapolated (`LoadInTime`) from those before,
///     misplaced = worn_share sqrt(max(0, |d|^2 - 2 s2)) / (2 |v|),
/// |.| over the zones of the liner (`zoned`), s2 the squares of d's standard errors: with four or
/// five zones that bear the load, noise alone passes 2 s2 in one step of ten. It takes two
/// loads or more (std::logic_error).
[[nodiscard]] StepError step_error(std::span<const TimedLoad> loads, double new_lifter_area);

/// How long the newest of `loads` is to stand before the load is measured anew [s], scheme
/// `adaptive`: the variable-step Adams-Bashforth method of second order with the error of the last
/// step held at `step_tolerance`,
///     h' = h min(2, max(1/2, 0.9 (step_tolerance / misplaced)^(1/3))),
/// the root being a square one after the first step, which is of first order. The first step wears
/// half of sqrt(2 step_tolerance) of the lifter, none more than `largest_share`.
/// Source: Hairer, Norsett and Wanner (1993), Solving Ordinary Differential Equations I, III.5.
[[nodiscard]] double time_to_next_load(std::span<const TimedLoad> loads, double new_lifter_area,
                                       const CampaignSettings& settings);

}  // namespace millwear::wear
