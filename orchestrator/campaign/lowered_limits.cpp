#include "orchestrator/campaign/lowered_limits.h"

#include "mill/case_file/case_lock.h"
#include "orchestrator/campaign/stage_order.h"

namespace millwear::orchestrator {

bool only_lowers_limits(const Case& here, const Case& there) {
  const auto& limits = here.campaign;
  if (limits.height_limit > there.campaign.height_limit ||
      limits.plate_limit > there.campaign.plate_limit)
    return false;
  Case lowered = there;
  lowered.dem.launcher = here.dem.launcher;
  lowered.campaign.height_limit = limits.height_limit;
  lowered.campaign.plate_limit = limits.plate_limit;
  lowered.campaign.cycle_limit = limits.cycle_limit;
  return locked_case_text(lowered) == locked_case_text(here);
}

Ledger reopened(Ledger ledger, const std::string& case_hash) {
  ledger.start.case_hash = case_hash;
  if (outcome_of(ledger) != Outcome::go_on) ledger.entries.pop_back();
  return ledger;
}

}  // namespace millwear::orchestrator
