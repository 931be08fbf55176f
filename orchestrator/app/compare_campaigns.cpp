#include "orchestrator/app/compare_campaigns.h"

#include <fmt/format.h>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "orchestrator/campaign/output_path.h"
#include "orchestrator/comparison/comparison.h"
#include "orchestrator/comparison/comparison_page.h"

namespace millwear::orchestrator {

void compare_campaigns(const std::vector<std::filesystem::path>& folders,
                       const std::optional<std::filesystem::path>& page, OutputForm form) {
  if (folders.size() > most_compared)
    throw Failure(ExitCode::usage,
                  fmt::format("{} campaigns are too many for one page; name {} at most",
                              folders.size(), most_compared));
  const std::filesystem::path file = page.value_or("comparison.html");
  check_output_file("--page", file, {});
  const Comparison comparison = comparison_of(compared_campaigns(folders));
  publish(file, comparison_html(comparison, file));
  if (form == OutputForm::json)
    fmt::print("{}\n", comparison_json(comparison));
  else
    fmt::print("{}page: {}\n", comparison_text(comparison), file.string());
}

}  // namespace millwear::orchestrator
