#pragma once
#include <string_view>

namespace millwear::orchestrator {

/// The page's own files as they stand in study/page, with the report's charts, compiled in.
extern const std::string_view study_page_html;
extern const std::string_view study_page_style;
extern const std::string_view study_page_script;

}  // namespace millwear::orchestrator
