#pragma once
#include <filesystem>

#include "liggghts_inputs/decks/stretch.h"
#include "mill/case/case.h"
#include "orchestrator/dem_run/measured.h"
#include "wear/record/liner_record.h"

namespace millwear::orchestrator {

/// Of the wall contacts, by number or normal impulse, so many at most may lie off the liner.
inline constexpr double largest_rejected_share = 1e-3;

/// What a measuring stretch tells besides the load: power from the torques that LIGGGHTS printed,
/// toe, shoulder and motion of the charge, and how well the rate of loss is known.
/// Throws DiskError where `torque_file` cannot be read, and ResultRejected where it ends early.
[[nodiscard]] Measured stretch_measures(const Case& mill, const LinerProfile& dem_liner,
                                        const liggghts::StretchSteps& steps,
                                        const wear::LinerRecord& record,
                                        const std::filesystem::path& torque_file);

}  // namespace millwear::orchestrator
