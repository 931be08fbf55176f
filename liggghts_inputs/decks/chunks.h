#pragma once
#include <vector>

#include "liggghts_inputs/decks/stretch.h"

namespace millwear::liggghts {

/// A part of a stretch that LIGGGHTS simulates by itself, from the restart file of the part before,
/// so that a stop costs one part at most.
struct Chunk {
  int number;  ///< from 0
  /// Its own steps. Behind the first, the charge settles for a pitch: the forces on the liner jump
  /// where a restart file has been read.
  StretchSteps steps;
  long measured_before = 0;  ///< steps of the measurement that the chunks before it measure
};

/// As few chunks of whole pitches, as even as can be, as hold the stretch in
/// `dem.chunk_particle_steps` each, the pitch of settling aside. They depend on the case alone. The
/// stretch stays whole where it is short enough, where it is a mixing that ends once it is steady,
/// and where the wall contacts come from dumps. Collisions between particles are recorded in the
/// last.
[[nodiscard]] std::vector<Chunk> chunks_of(const Case& mill, const StretchSteps& stretch,
                                           const StepPlan& plan);

/// The chunk by which a measurement in chunks goes on after `last`: `stretch.go_on_steps`.
[[nodiscard]] Chunk chunk_after(const Chunk& last, const StretchSteps& stretch,
                                const StepPlan& plan);

}  // namespace millwear::liggghts
