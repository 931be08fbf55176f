#include "liggghts_inputs/decks/chunks.h"

#include <algorithm>
#include <cmath>

namespace millwear::liggghts {
namespace {

bool is_one_chunk(const Case& mill, const StretchSteps& stretch) {
  const bool is_mixing = stretch.measure_steps == 0;
  return mill.dem.contact_path == ContactPath::dumps || (is_mixing && mill.dem.mix_until_steady);
}

/// Pitches up to the end of part `number` of `count` even ones.
long pitches_until(long pitches, long number, long count) { return pitches * (number + 1) / count; }

}  // namespace

std::vector<Chunk> chunks_of(const Case& mill, const StretchSteps& stretch, const StepPlan& plan) {
  const double particle_steps =
      static_cast<double>(totals(mill).particles) * static_cast<double>(stretch.total());
  const bool is_mixing = stretch.measure_steps == 0;
  const long divided = is_mixing ? stretch.settle_steps : stretch.measure_steps;
  const long pitches = divided / plan.steps_per_pitch;
  const long count =
      is_one_chunk(mill, stretch)
          ? 1
          : std::clamp(std::lround(std::ceil(particle_steps / mill.dem.chunk_particle_steps)), 1L,
                       std::max(1L, pitches));
  if (count == 1) return {{0, stretch}};
  std::vector<Chunk> chunks;
  for (long number = 0, before = 0; number < count; ++number) {
    const long until = pitches_until(pitches, number, count) * plan.steps_per_pitch;
    StretchSteps steps = stretch;
    steps.go_on_steps = 0;
    steps.most_measure_steps = 0;
    steps.torque_steps = stretch.torque_interval();
    (is_mixing ? steps.settle_steps : steps.measure_steps) = until - before;
    if (!is_mixing && number > 0) steps.settle_steps = plan.steps_per_pitch;
    steps.pair_steps = number + 1 == count ? std::min(stretch.pair_steps, steps.measure_steps) : 0;
    chunks.push_back({static_cast<int>(number), steps, is_mixing ? 0 : before});
    before = until;
  }
  return chunks;
}

Chunk chunk_after(const Chunk& last, const StretchSteps& stretch, const StepPlan& plan) {
  Chunk next{last.number + 1, last.steps, last.measured_before + last.steps.measure_steps};
  next.steps.settle_steps = plan.steps_per_pitch;
  next.steps.measure_steps = stretch.go_on_steps;
  next.steps.pair_steps = 0;
  return next;
}

}  // namespace millwear::liggghts
