#include "orchestrator/report/report.h"

#include <map>
#include <stdexcept>
#include <string_view>

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

std::string filled(std::string_view page, const std::map<std::string_view, std::string>& parts) {
  std::string text;
  for (;;) {
    const auto open = page.find("{{");
    text += page.substr(0, open);
    if (open == std::string_view::npos) return text;
    const auto close = page.find("}}", open);
    const auto part = parts.find(page.substr(open + 2, close - open - 2));
    if (part == parts.end()) throw std::logic_error("page.html names a part that is not there");
    text += part->second;
    page.remove_prefix(close + 2);
  }
}

}  // namespace

std::string report_html(const CampaignResults& data, const D3& d3) {
  return filled(page_html, {{"title", html_text(data.case_name)},
                            {"style", std::string(page_style)},
                            {"d3", d3.script},
                            {"d3_licence", html_text(d3.licence)},
                            {"script", std::string(page_script)},
                            {"data", report_json(data)}});
}

}  // namespace millwear::orchestrator
