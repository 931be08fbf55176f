#include "orchestrator/report/report_files.h"

#include "mill/base/published_file.h"
#include "orchestrator/report/plots.h"
#include "orchestrator/report/report.h"

namespace millwear::orchestrator {

void publish_report(const std::filesystem::path& page, const CampaignResults& data) {
  publish(page, report_html(data));
}

void publish_pictures(const std::filesystem::path& folder, const CampaignResults& data) {
  write_plots(data, folder);
}

}  // namespace millwear::orchestrator
