#pragma once
#include "mill/case/case.h"
#include "mill/liner/rotation.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/dem_run/measured.h"
#include "orchestrator/dem_run/progress.h"
#include "orchestrator/campaign/run_folder.h"
#include "wear/rate/load_rate.h"
#include "wear/evolve/timed_load.h"

namespace millwear::orchestrator {

/// What every stage of a campaign needs to know.
struct Campaign {
  Case mill;
  RunFolder folder;
  int ranks;
};

/// The liner that a cycle begins with: the new one, or what the cycle before left. In the steel's
/// frame, xi along the rotation when the liner was new.
[[nodiscard]] LinerProfile liner_of_cycle(const Campaign& campaign, int cycle);

/// Which way the mill turns during a cycle.
[[nodiscard]] Rotation rotation_of_cycle(const Campaign& campaign, int cycle);

/// The same liner in the DEM's frame, xi along the rotation of the cycle: mesh, deck and load are
/// on this one.
[[nodiscard]] LinerProfile dem_liner_of_cycle(const Campaign& campaign, int cycle);

/// The first cycle with the rotation of this one: its DEM begins with a new charge.
[[nodiscard]] int first_cycle_of_rotation(const Campaign& campaign, int cycle);

/// Time that the mill has milled when a cycle's load is measured, since its liner was new [s].
[[nodiscard]] double milling_time_before(const Campaign& campaign, int cycle);

/// The load of a cycle on its liner; `time` is when it was measured, `milling_time_before` [s].
[[nodiscard]] wear::TimedLoad timed_load(const Campaign& campaign, int cycle, double time,
                                         const wear::LoadRate& rate);

/// Share of the way from the new lifter to its limit, 0 ... 1, that a liner has gone.
[[nodiscard]] double share_of_life(const Case& mill, const LinerProfile& liner);

/// Runs one stage in a folder beside its own and publishes it by a rename; what an earlier attempt
/// left is removed. Returns what the ledger is to hold.
[[nodiscard]] LedgerEntry run_stage(const Campaign& campaign, const StageId& stage,
                                    Progress& progress);

/// Makes a folder and those above it. Throws DiskError.
void make_folder(const std::filesystem::path& folder);

/// The work of each stage, into `into`; `wear` tells how it leaves the liner.
void mesh_stage(const Campaign& campaign, int cycle, const std::filesystem::path& into);
void mix_stage(const Campaign& campaign, int cycle, const std::filesystem::path& into,
               Progress& progress);
void dem_stage(const Campaign& campaign, int cycle, const std::filesystem::path& into,
               Progress& progress);
void tune_stage(const Campaign& campaign, const std::filesystem::path& into, Progress& progress);
[[nodiscard]] Outcome wear_stage(const Campaign& campaign, int cycle,
                                 const std::filesystem::path& into);

/// The case that a stretch's decks are written for: with the settings that the campaign's tune
/// stage chose, where it has one and the stretch is after it. Throws what `read_tuning` throws.
[[nodiscard]] Case case_of_stretch(const Campaign& campaign, const StageId& stage);

/// The decks of a stretch and, for a mixing one, its charge, written into `into`.
void write_mixing_deck(const Campaign& campaign, int cycle, const std::filesystem::path& into);
void write_measuring_deck(const Campaign& campaign, int cycle, const std::filesystem::path& into);

/// What millwear-recorder is told of a measuring stretch, besides its deck; paths are from the
/// stage's folder.
[[nodiscard]] std::vector<std::string> recorder_arguments(const Case& mill);

}  // namespace millwear::orchestrator
