#pragma once
#include <string>

#include "orchestrator/report/script_library.h"
#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// A page that shows a campaign and needs nothing but a browser: data, drawing program and style
/// are inside, and its own policy forbids it to load anything.
[[nodiscard]] std::string report_html(const CampaignResults& data,
                                      const PageLibraries& libraries = installed_page_libraries());

}  // namespace millwear::orchestrator
