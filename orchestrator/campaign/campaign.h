#pragma once
#include <filesystem>
#include <optional>

#include "mill/case/case.h"
#include "mill/case/operating_change.h"
#include "mill/liner/rotation.h"
#include "orchestrator/campaign/run_folder.h"

namespace millwear::orchestrator {

/// What every stage of a campaign needs to know.
struct Campaign {
  Case mill;
  RunFolder folder;
  int ranks;
  /// Where campaigns of one study leave their DEM for each other (stages/shared_stages.h).
  std::optional<std::filesystem::path> shared_stages{};
  /// Where files grow before they are published, if not in the campaign's own folder
  /// (campaign/work_folder.h).
  std::optional<std::filesystem::path> scratch{};
};

/// The liner that a cycle begins with: the new one, or what the cycle before left. In the steel's
/// frame, xi along the rotation when the liner was new.
[[nodiscard]] LinerProfile liner_of_cycle(const Campaign& campaign, int cycle);

/// Which way the mill turns during a cycle.
[[nodiscard]] Rotation rotation_of_cycle(const Campaign& campaign, int cycle);

/// The same liner in the DEM's frame, xi along the rotation of the cycle: mesh, deck and load are
/// on this one.
[[nodiscard]] LinerProfile dem_liner_of_cycle(const Campaign& campaign, int cycle);

/// The first cycle with the operation of this one (mill/case/operated_mill.h): its DEM begins with
/// a new charge.
[[nodiscard]] int first_cycle_of_operation(const Campaign& campaign, int cycle);

/// The campaign with its mill as it is operated when a cycle begins: speed, charge and feed rate.
[[nodiscard]] Campaign as_operated(const Campaign& campaign, int cycle);

/// Where the liner stands when a cycle begins.
[[nodiscard]] LinerMoment moment_before(const Campaign& campaign, int cycle);

/// Time that the mill has milled when a cycle's load is measured, since its liner was new [s].
[[nodiscard]] double milling_time_before(const Campaign& campaign, int cycle);

/// Share of the way from the new lifter to its limit, 0 ... 1, that a liner has gone.
[[nodiscard]] double share_of_life(const Case& mill, const LinerProfile& liner);

}  // namespace millwear::orchestrator
