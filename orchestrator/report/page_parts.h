#pragma once
#include <string>
#include <string_view>

#include "orchestrator/report/script_library.h"

namespace millwear::orchestrator {

/// A page's own files as they stand in its folder, compiled in.
struct PageParts {
  std::string_view html;  ///< with a place for each of the others
  std::string_view style;
  std::string_view script;
};

/// Those of the report, in `page`.
extern const PageParts report_page;

/// A page with everything inside: `data` is JSON as it may stand in a script element.
[[nodiscard]] std::string filled_page(const PageParts& parts, std::string_view title,
                                      const PageLibraries& libraries, std::string data);

}  // namespace millwear::orchestrator
