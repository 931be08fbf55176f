#pragma once
#include <algorithm>
#include <string>
#include <string_view>

#include "mill/case/case.h"
#include "mill/case/time_step.h"

namespace millwear::liggghts {

/// The last line a deck prints. LIGGGHTS can stop half way with exit code 0, so only this counts.
inline constexpr std::string_view sentinel = "millwear: stretch complete";

/// How a stretch's steps are laid out: both parts take whole pitches, so that a stretch begins and
/// ends with lifter 0 at a place where another lifter stood.
struct StretchSteps {
  double time_step;     ///< [s]
  long settle_steps;    ///< before anything is measured (the whole of a mixing stretch)
  long measure_steps;   ///< 0 for a mixing stretch
  long sample_steps;    ///< between two samples of the wall contacts, from the end of settling on
  long pair_steps = 0;  ///< at the end of `measure_steps`, to record collisions between particles
  /// A measurement that goes on until it knows enough does so by these, whole pitches and whole
  /// time blocks both; 0 for one that does not.
  long go_on_steps = 0;
  long most_measure_steps = 0;  ///< ... and ends with these; 0 for one that does not go on
  long torque_steps = 0;  ///< the liner's torque is averaged over these; 0: over a two hundredth
                          ///< of `measure_steps`
  [[nodiscard]] long total() const { return settle_steps + measure_steps; }
  /// The last step, however long the measurement goes on.
  [[nodiscard]] long most_total() const {
    return settle_steps + std::max(measure_steps, most_measure_steps);
  }
  [[nodiscard]] double measure_time() const;  ///< [s]
  /// Steps in (settle, total] that are sampled: every `sample_steps` after settling, and the last.
  [[nodiscard]] long samples() const;
  [[nodiscard]] double sample_interval() const;  ///< [s]
  [[nodiscard]] long torque_interval() const;    ///< steps
};

/// Mixes for `dem.mix_revolutions`, rounded up to whole pitches; at most for that, in whole pieces,
/// where it ends once it is steady (mill/load/steady_mixing.h).
[[nodiscard]] StretchSteps mixing_steps(const Case& mill, const StepPlan& plan);

/// Settles for `dem.settle_pitches`, then measures for `dem.measure_revolutions`, rounded up to
/// whole pitches. With `dem.error_target` it may go on, by the fewest pitches that are whole time
/// blocks too, up to `most_revolutions` rounded up to such.
[[nodiscard]] StretchSteps measuring_steps(const Case& mill, const StepPlan& plan);

/// A measuring stretch as it went, with what was measured in `duration` [s]: `measure_steps` are
/// those of that time. Throws ResultRejected, with what may have been, where a measurement of these
/// steps could not have come to that length.
[[nodiscard]] StretchSteps as_measured(const StretchSteps& planned, double duration);

}  // namespace millwear::liggghts
