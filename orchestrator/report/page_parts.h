#pragma once
#include <string_view>

namespace millwear::orchestrator {

/// The report's own files as they stand in this folder, compiled in.
extern const std::string_view page_html;
extern const std::string_view page_style;
extern const std::string_view page_script;

}  // namespace millwear::orchestrator
