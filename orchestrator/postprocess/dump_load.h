#pragma once
#include "mill/case/case.h"
#include "orchestrator/postprocess/dump_outline.h"
#include "orchestrator/postprocess/hand_run.h"
#include "wear/record/liner_record.h"

namespace millwear::orchestrator {

/// The load that a run made by hand left on a liner.
struct DumpLoad {
  wear::LinerRecord record;
  DumpOutline outline;
};

/// Reads the dumps of a run and sums the load on the case's liner, whose mesh has so many
/// triangles, as a campaign with `wall_contacts = "dumps"` does: one of the same deck gives the
/// same record to the last bit. Throws InputError, with the file, where the dumps cannot be read,
/// are not of one run, or not of this mill and liner.
[[nodiscard]] DumpLoad load_of_dumps(const Case& mill, std::size_t triangles, const HandRun& run);

}  // namespace millwear::orchestrator
