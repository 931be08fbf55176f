#include "orchestrator/report/report.h"

#include "mill/base/text_template.h"
#include "orchestrator/report/html_text.h"
#include "orchestrator/report/page_parts.h"
#include "orchestrator/report/report_json.h"

namespace millwear::orchestrator {
std::string report_html(const CampaignResults& data, const PageLibraries& libraries) {
  return filled_template(page_html, {{"title", html_text(data.case_name)},
                                     {"style", std::string(page_style)},
                                     {"d3", libraries.d3.script},
                                     {"d3_licence", html_text(libraries.d3.licence)},
                                     {"pako", libraries.pako.script},
                                     {"pako_licence", html_text(libraries.pako.licence)},
                                     {"script", std::string(page_script)},
                                     {"data", report_json(data)}});
}

}  // namespace millwear::orchestrator
