#pragma once
#include "orchestrator/dem_run/measured.h"
#include "orchestrator/results/campaign_results.h"
#include "wear/record/liner_record.h"

namespace millwear::orchestrator {

/// What the charge did in one cycle, for the report.
[[nodiscard]] MotionOfCycle motion_of_cycle(int cycle, const Measured& measured,
                                            const wear::LinerRecord& record);

}  // namespace millwear::orchestrator
