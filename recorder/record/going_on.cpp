#include "recorder/record/going_on.h"

#include <algorithm>
#include <cmath>

#include "wear/rate/load_rate.h"

namespace millwear::recorder {
namespace {

long expected_step(const RecordingPlan& plan, const wear::MeasurementGoal& goal) {
  const auto& going_on = *plan.going_on;
  const auto measured = static_cast<double>(plan.last_step - plan.first_step);
  const double missing = wear::length_to_reach(goal, measured) - measured;
  const auto room = static_cast<double>(going_on.at_most - plan.last_step) /
                    static_cast<double>(going_on.by_steps);
  const double pieces =
      std::clamp(std::ceil(missing / static_cast<double>(going_on.by_steps)), 1.0, room);
  return plan.last_step + std::lround(pieces) * going_on.by_steps;
}

}  // namespace

NextPiece next_piece(const Case& mill, const RecordingPlan& plan, const LinerProfile& liner,
                     const WallLoad& load) {
  const auto& going_on = *plan.going_on;
  const wear::MeasurementGoal goal{
      going_on.target_error, wear::peak_error_of_load(mill.wear, mill.charge.classes, liner, load)};
  if (wear::is_reached(goal) || plan.last_step + going_on.by_steps > going_on.at_most)
    return {goal, 0, plan.last_step};
  return {goal, going_on.by_steps, expected_step(plan, goal)};
}

MeasuringLine line_for_log(const RecordingPlan& plan, const NextPiece& next) {
  MeasuringLine line{plan.last_step, next.goal.peak_error, next.goal.target_error, {}};
  if (next.steps > 0) line.next = NextEnd{plan.last_step + next.steps, next.expected_step};
  return line;
}

}  // namespace millwear::recorder
