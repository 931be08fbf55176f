#pragma once
#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "orchestrator/app/common_options.h"
#include "orchestrator/campaign/open_campaign.h"
#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// Writes the results and the report of a campaign so far. `readings` is the folder of the gauge
/// readings where the user named one: a table there that cannot be taken is an error, and only a
/// warning where it was not named.
CampaignResults publish_campaign(const OpenCampaign& opened,
                                 const std::optional<std::filesystem::path>& readings);

/// Draws the pictures of a published campaign, and writes the report again with those of the charge
/// of the first, the last and the `chosen` cycles. Throws ExternalProgramError where gnuplot or
/// tachyon is missing or fails.
void publish_pictures(const OpenCampaign& opened, const std::set<int>& chosen,
                      CampaignResults& data);

/// The same at the end of a run: a campaign does not fail for want of a program that draws.
void publish_pictures_if_possible(const OpenCampaign& opened, CampaignResults& data,
                                  Progress& progress);

/// "worn out at 2104 h: lifter 18.0 mm high, ..."
[[nodiscard]] std::string spoken_outcome(const CampaignResults& data);

/// Prints how the campaign stands and where its report lies.
void print_outcome(OutputForm form, const RunFolder& folder, const CampaignResults& data);

}  // namespace millwear::orchestrator
