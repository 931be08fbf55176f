#include "orchestrator/report/report.h"

#include "orchestrator/report/page_parts.h"
#include "orchestrator/report/report_json.h"

namespace millwear::orchestrator {
std::string report_html(const CampaignResults& data, const PageLibraries& libraries) {
  return filled_page(report_page, data.case_name, libraries, report_json(data));
}

}  // namespace millwear::orchestrator
