#pragma once
#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// A made-up charge on a liner of `age` 0 (new) to 1 (worn): a bed that fills the lower left half
/// of the section and turns with the mill around a place in its middle, steel and ore.
[[nodiscard]] ChargeOfCycle synthetic_charge(int cycle, double age, const LinerProfile& liner);

/// Its load of `bins` bins: sliding on the rising side, hits beyond the toe.
[[nodiscard]] wear::PolarLoad synthetic_polar_load(int bins);

}  // namespace millwear::orchestrator
