#pragma once
#include <vector>

#include "orchestrator/postprocess/hand_run.h"

namespace millwear::orchestrator {

/// What the two dumps of a run hold, before they are joined.
struct DumpOutline {
  std::vector<long> steps;           ///< in the measurement, with which it begins first
  long sample_steps = 0;             ///< between two of them; the first or last may be nearer
  std::size_t contacts = 0;          ///< with the wall, after the first step
  std::size_t largest_particle = 0;  ///< particle number
};

/// Reads both dumps once. `triangles` are those of the mesh. Throws ResultRejected, with file and
/// line or file and step, where a dump is torn, lacks a column, is out of order or holds a number
/// that cannot be, where the two do not hold the same steps, where snapshots are missing, and where
/// there are fewer than two or no contact in them.
[[nodiscard]] DumpOutline outline_of(const HandRun& run, std::size_t triangles);

}  // namespace millwear::orchestrator
