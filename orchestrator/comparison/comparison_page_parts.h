#pragma once
#include <string_view>

namespace millwear::orchestrator {

/// The page's own files as they stand in comparison/page, with those of the report, compiled in.
extern const std::string_view comparison_page_html;
extern const std::string_view comparison_page_style;
extern const std::string_view comparison_page_script;

}  // namespace millwear::orchestrator
