#pragma once
#include <filesystem>
#include <limits>

#include "mill/case/case.h"
#include "orchestrator/postprocess/hand_run.h"
#include "wear/evolve/evolution.h"

namespace millwear::orchestrator {

/// What the dumps of a run say of the wear of its liner.
struct PostprocessedDumps {
  long first_step;
  long last_step;
  long samples;
  std::size_t contacts;
  double measured;         ///< [s]
  double rejected_share;   ///< of the normal impulse
  double section_rate;     ///< steel that a lifter loses per length of mill [m2/s]
  double peak_error;       ///< relative standard error of the smoothed rate at its peaks
  double milled;           ///< for which the liner was worn [s]
  wear::EvolutionEnd end;  ///< of the milling
  LinerProfile worn;
};

/// Reads the dumps of a run on the liner `deck_liner`, applies the case's wear law and moves the
/// profile until its limit, until the load is spent or for `longest` [s]. Leaves in the new folder
/// `out`: load.h5, steps.json, and of the worn liner profile.csv, liner.stl, profile.step,
/// profile.dxf and mesh.json. Throws what `load_of_dumps`, `triangles_of_deck`, `evolve`,
/// `write_mesh` and `NewFolder` throw; nothing is written then.
[[nodiscard]] PostprocessedDumps postprocess_dumps(
    const Case& mill, const LinerProfile& deck_liner, const HandRun& run,
    const std::filesystem::path& out, double longest = std::numeric_limits<double>::infinity());

}  // namespace millwear::orchestrator
