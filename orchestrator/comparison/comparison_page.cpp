#include "orchestrator/comparison/comparison_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "orchestrator/report/html_text.h"
#include "orchestrator/report/report_json.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t frame_bytes_of_page = 4'000'000;  // before they are packed

/// The report as it is reached from the page's folder; null where it lies elsewhere.
Json link_to(const fs::path& report, const fs::path& page) {
  const fs::path from = fs::weakly_canonical(fs::absolute(page).parent_path());
  const fs::path way = fs::weakly_canonical(fs::absolute(report)).lexically_relative(from);
  if (!fs::exists(report) || way.empty() || way.begin()->string() == "..") return nullptr;
  return way.generic_string();
}

/// What `comparison_json` has, with the data of each campaign as its report has them.
std::string page_json(const Comparison& comparison, const fs::path& page) {
  const Json words = Json::parse(comparison_json(comparison));
  const std::size_t frame_bytes = frame_bytes_of_page / (2 * comparison.campaigns.size());
  std::string campaigns;
  for (std::size_t i = 0; i < comparison.campaigns.size(); ++i) {
    const auto& compared = comparison.campaigns[i];
    Json campaign = words["campaigns"][i];
    campaign["report"] = link_to(compared.campaign.folder.report(), page);
    std::string text = inside_script(campaign.dump());
    text.pop_back();
    campaigns +=
        (i > 0 ? "," : "") + text + ",\"data\":" + report_json(compared.data, frame_bytes) + "}";
  }
  return fmt::format("{{\"campaigns\":[{}],\"differing\":{}}}", campaigns,
                     inside_script(words["differing"].dump()));
}

std::string title_of(const Comparison& comparison) {
  std::vector<std::string> names;
  for (const auto& compared : comparison.campaigns) names.push_back(compared.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::string comparison_html(const Comparison& comparison, const fs::path& page,
                            const PageLibraries& libraries) {
  return filled_page(comparison_page, title_of(comparison), libraries, page_json(comparison, page));
}

}  // namespace millwear::orchestrator
