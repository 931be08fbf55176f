#include "orchestrator/report/report.h"

#include <string_view>

#include "mill/base/text_template.h"
#include "orchestrator/report/page_parts.h"
#include "orchestrator/report/report_json.h"

namespace millwear::orchestrator {
namespace {

std::string html_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  return escaped;
}

}  // namespace

std::string report_html(const CampaignResults& data, const D3& d3) {
  return filled_template(page_html, {{"title", html_text(data.case_name)},
                                     {"style", std::string(page_style)},
                                     {"d3", d3.script},
                                     {"d3_licence", html_text(d3.licence)},
                                     {"script", std::string(page_script)},
                                     {"data", report_json(data)}});
}

}  // namespace millwear::orchestrator
