#pragma once
#include <filesystem>
#include <optional>
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

/// Draws the pictures. They are a convenience: a campaign does not fail for want of gnuplot.
void publish_pictures_if_possible(const RunFolder& folder, const CampaignResults& data,
                                  Progress& progress);

/// "worn out at 2104 h: lifter 18.0 mm high, ..."
[[nodiscard]] std::string spoken_outcome(const CampaignResults& data);

/// Prints how the campaign stands and where its report lies.
void print_outcome(OutputForm form, const RunFolder& folder, const CampaignResults& data);

}  // namespace millwear::orchestrator
