#include "orchestrator/report/html_text.h"

namespace millwear::orchestrator {

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

std::string inside_script(std::string_view json) {
  std::string text;
  text.reserve(json.size());
  for (;;) {
    const auto open = json.find('<');
    text += json.substr(0, open);
    if (open == std::string_view::npos) return text;
    text += "\\u003c";
    json.remove_prefix(open + 1);
  }
}

}  // namespace millwear::orchestrator
