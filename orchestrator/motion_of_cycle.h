#pragma once
#include "orchestrator/measured.h"
#include "orchestrator/report/report_data.h"
#include "wear/liner_record.h"

namespace millwear::orchestrator {

/// What the charge did in one cycle, for the report.
[[nodiscard]] MotionOfCycle motion_of_cycle(int cycle, const Measured& measured,
                                            const wear::LinerRecord& record);

}  // namespace millwear::orchestrator
