#include "orchestrator/report/page_parts.h"

#include <utility>

#include "mill/base/text_template.h"
#include "orchestrator/report/html_text.h"

namespace millwear::orchestrator {

std::string filled_page(const PageParts& parts, std::string_view title,
                        const PageLibraries& libraries, std::string data) {
  return filled_template(parts.html, {{"title", html_text(title)},
                                      {"style", std::string(parts.style)},
                                      {"d3", libraries.d3.script},
                                      {"d3_licence", html_text(libraries.d3.licence)},
                                      {"pako", libraries.pako.script},
                                      {"pako_licence", html_text(libraries.pako.licence)},
                                      {"script", std::string(parts.script)},
                                      {"data", std::move(data)}});
}

}  // namespace millwear::orchestrator
