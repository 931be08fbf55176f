#pragma once
#include <string>
#include <string_view>

namespace millwear::orchestrator {

/// The text as HTML shows it.
[[nodiscard]] std::string html_text(std::string_view text);

/// JSON as it may stand inside a script element.
[[nodiscard]] std::string inside_script(std::string_view json);

}  // namespace millwear::orchestrator
