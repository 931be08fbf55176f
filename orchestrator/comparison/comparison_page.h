#pragma once
#include <filesystem>
#include <string>

#include "orchestrator/comparison/comparison.h"
#include "orchestrator/report/page_parts.h"

namespace millwear::orchestrator {

/// The page's own files, in `page`, with those of the report.
extern const PageParts comparison_page;

/// A page that shows campaigns side by side and needs nothing but a browser. It will lie at `page`;
/// it links to the reports that lie below the same folder.
[[nodiscard]] std::string comparison_html(
    const Comparison& comparison, const std::filesystem::path& page,
    const PageLibraries& libraries = installed_page_libraries());

}  // namespace millwear::orchestrator
