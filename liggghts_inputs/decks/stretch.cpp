#include "liggghts_inputs/decks/stretch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mill/base/failure.h"
#include "mill/load/steady_mixing.h"

namespace millwear::liggghts {
namespace {

constexpr long torque_values = 200;

long whole_pitches(double revolutions, int rows) {
  return static_cast<long>(std::ceil(revolutions * rows - 1e-9));
}

/// The fewest pitches that are whole time blocks of a measurement of so many pitches.
long pitches_to_go_on(long pitches, long blocks) { return pitches / std::gcd(pitches, blocks); }

}  // namespace

double StretchSteps::measure_time() const { return time_step * static_cast<double>(measure_steps); }
long StretchSteps::samples() const { return (measure_steps + sample_steps - 1) / sample_steps; }
double StretchSteps::sample_interval() const {
  return time_step * static_cast<double>(sample_steps);
}

long StretchSteps::torque_interval() const {
  return torque_steps > 0 ? torque_steps : std::max(1L, measure_steps / torque_values);
}

StretchSteps mixing_steps(const Case& mill, const StepPlan& plan) {
  if (mill.dem.mix_until_steady)
    return {plan.time_step, mixing_plan(mill, plan).most, 0, mill.dem.sample_every_steps};
  const long pitches = whole_pitches(mill.dem.mix_revolutions, mill.liner.sector.rows);
  return {plan.time_step, pitches * plan.steps_per_pitch, 0, mill.dem.sample_every_steps};
}

StretchSteps measuring_steps(const Case& mill, const StepPlan& plan) {
  const long pitches = whole_pitches(mill.dem.measure_revolutions, mill.liner.sector.rows);
  const long measured = pitches * plan.steps_per_pitch;
  const auto pair_steps =
      static_cast<long>(mill.dem.pair_revolutions *
                        static_cast<double>(plan.steps_per_revolution(mill.liner.sector.rows)));
  StretchSteps steps{
      plan.time_step, mill.dem.settle_pitches * plan.steps_per_pitch, measured,
      mill.dem.sample_every_steps,
      mill.dem.contact_path == ContactPath::recorder ? std::min(pair_steps, measured) : 0};
  if (const auto& target = mill.dem.error_target) {
    const long piece = pitches_to_go_on(pitches, mill.wear.time_blocks);
    const long wanted = whole_pitches(target->most_revolutions, mill.liner.sector.rows) - pitches;
    const long pieces = (std::max(wanted, 0L) + piece - 1) / piece;
    steps.go_on_steps = piece * plan.steps_per_pitch;
    steps.most_measure_steps = measured + pieces * steps.go_on_steps;
  }
  return steps;
}

StretchSteps as_measured(const StretchSteps& planned, double duration) {
  const long least = planned.measure_steps;
  const long most = std::max(least, planned.most_measure_steps);
  const long piece = std::max(1L, planned.go_on_steps);
  const long measured = std::lround(duration / planned.time_step);
  if (measured < least || measured > most || (measured - least) % piece != 0)
    throw ResultRejected(
        fmt::format("the load was measured over {} steps and not over {}", measured,
                    most > least ? fmt::format("{} to {} in pieces of {}", least, most, piece)
                                 : std::to_string(least)));
  StretchSteps went = planned;
  went.measure_steps = measured;
  return went;
}

}  // namespace millwear::liggghts
