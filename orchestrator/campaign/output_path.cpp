#include "orchestrator/campaign/output_path.h"

#include <fmt/format.h>

#include "mill/base/failure.h"
#include "orchestrator/campaign/run_folder.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

bool is_campaign(const fs::path& place) {
  const RunFolder folder{place};
  return fs::exists(folder.ledger()) ||
         (fs::exists(folder.locked_case()) &&
          (fs::exists(place / "history.csv") || fs::exists(folder.results() / "history.csv")));
}

/// The campaign's folder that `place` is or lies in; empty where it is in none.
fs::path campaign_around(const fs::path& place) {
  for (fs::path folder = place; !folder.empty(); folder = folder.parent_path()) {
    if (is_campaign(folder)) return folder;
    if (folder == folder.parent_path()) break;
  }
  return {};
}

[[noreturn]] void refuse(std::string_view option, const fs::path& path, const std::string& why) {
  throw Failure(ExitCode::usage, fmt::format("{} {}: {}", option, path.string(), why));
}

void refuse_in_campaign(std::string_view option, const fs::path& path, const fs::path& around) {
  if (const fs::path campaign = campaign_around(around); !campaign.empty())
    refuse(option, path,
           fmt::format("this is among the campaign's own files in {}; name a place elsewhere",
                       campaign.string()));
}

}  // namespace

void check_output_file(std::string_view option, const fs::path& file,
                       std::initializer_list<fs::path> inputs) {
  const fs::path place = fs::weakly_canonical(fs::absolute(file));
  if (fs::is_directory(place)) refuse(option, file, "this is a folder; name a file");
  if (!fs::is_directory(place.parent_path()))
    refuse(option, file,
           fmt::format("there is no folder {}; make it first", place.parent_path().string()));
  for (const auto& input : inputs)
    if (!input.empty() && fs::weakly_canonical(fs::absolute(input)) == place)
      refuse(option, file, "this file is read by the same command; name another");
  refuse_in_campaign(option, file, place.parent_path());
}

void check_output_folder(std::string_view option, const fs::path& folder) {
  refuse_in_campaign(option, folder, fs::weakly_canonical(fs::absolute(folder)));
}

void check_campaign_folder(std::string_view option, const fs::path& folder) {
  refuse_in_campaign(option, folder, fs::weakly_canonical(fs::absolute(folder)).parent_path());
}

}  // namespace millwear::orchestrator
