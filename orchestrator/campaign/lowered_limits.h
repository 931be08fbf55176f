#pragma once
#include <string>

#include "mill/case/case.h"
#include "orchestrator/campaign/ledger.h"

namespace millwear::orchestrator {

/// Whether `here` differs from `there`, the case a campaign was begun with, in nothing but limits
/// of height and plate that are no higher, or in `cycle_limit`: what was done stands then as it is,
/// but for the wear that was cut short at a former limit.
[[nodiscard]] bool only_lowers_limits(const Case& here, const Case& there);

/// The ledger of a campaign that goes on to lower limits: with the hash of the case that has them,
/// and without a last wear that ended at a former one.
[[nodiscard]] Ledger reopened(Ledger ledger, const std::string& case_hash);

}  // namespace millwear::orchestrator
