#pragma once
#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/dem_run/progress.h"

namespace millwear::orchestrator {

/// Runs one stage, with the mill as it is operated in its cycle, in a folder beside its own and
/// publishes it by a rename; what an earlier attempt left is removed. Returns what the ledger is to
/// hold.
[[nodiscard]] LedgerEntry run_stage(const Campaign& campaign, const StageId& stage,
                                    Progress& progress);

}  // namespace millwear::orchestrator
