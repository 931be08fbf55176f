#include "orchestrator/report/report.h"

#include "mill/base/text_template.h"
#include "orchestrator/report/html_text.h"
#include "orchestrator/report/page_parts.h"
#include "orchestrator/report/report_json.h"

namespace millwear::orchestrator {
std::string report_html(const CampaignResults& data, const D3& d3) {
  return filled_template(page_html, {{"title", html_text(data.case_name)},
                                     {"style", std::string(page_style)},
                                     {"d3", d3.script},
                                     {"d3_licence", html_text(d3.licence)},
                                     {"script", std::string(page_script)},
                                     {"data", report_json(data)}});
}

}  // namespace millwear::orchestrator
