#pragma once
#include "mill/case/case.h"
#include "mill/load/wall_load.h"
#include "mill/recording/recorder_lines.h"
#include "mill/recording/recorder_orders.h"
#include "wear/record/measurement_goal.h"

namespace millwear::recorder {

/// What follows where a measurement that may go on has come to its last step.
struct NextPiece {
  wear::MeasurementGoal goal;
  long steps;          ///< to go on by; 0: it ends here
  long expected_step;  ///< where it is likely to end
};

/// Goes on by `by_steps` while the peaks are not known well enough and `at_most` is not reached.
/// `load` is that of all ranks on `liner` up to `plan.last_step`; the law and the smoothing are the
/// case's. Throws as `rate_of_load` does.
[[nodiscard]] NextPiece next_piece(const Case& mill, const RecordingPlan& plan,
                                   const LinerProfile& liner, const WallLoad& load);

/// The line for the log, for whoever follows the recorder.
[[nodiscard]] MeasuringLine line_for_log(const RecordingPlan& plan, const NextPiece& next);

}  // namespace millwear::recorder
