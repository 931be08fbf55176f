#include "orchestrator/study/study_folder.h"

#include <fmt/format.h>

#include <algorithm>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/base/whole_file.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

constexpr const char* point_case = "case.toml";

int number_of(const fs::path& folder) {
  const std::string name = folder.filename().string();
  int number = 0;
  for (const char c : name) {
    if (c < '0' || c > '9') break;
    number = 10 * number + (c - '0');
  }
  return number;
}

/// Letters, digits and what else a folder's name may have anywhere.
std::string as_folder_name(std::string_view text) {
  std::string name;
  for (const char c : text) {
    const bool is_plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
                          (c >= 'A' && c <= 'Z') ||
                          std::string_view("._-+,=[]").find(c) != std::string_view::npos;
    name += is_plain ? c : '_';
  }
  return name.substr(0, 80);
}

std::string last_part(const std::string& key) { return key.substr(key.rfind('.') + 1); }

std::string locked_text(const StudyPlan& plan) {
  return fmt::format(
      "# The study that this folder belongs to. Written by millwear.\nformat_version = 1\n"
      "name = \"{}\"\nbase_case = \"{}\"\n",
      plan.study.name, plan.base.name);
}

/// The base case of a locked study.
std::string base_case_in(const fs::path& file) {
  const std::string text = read_file(file);
  const std::string key = "base_case = \"";
  const auto from = text.find(key);
  if (from == std::string::npos) return "";
  return text.substr(from + key.size(), text.find('"', from + key.size()) - from - key.size());
}

bool varies(const StudyPlan& plan, std::size_t axis) {
  return std::ranges::any_of(plan.points, [&](const PointValues& point) {
    return point.labels[axis] != plan.points.front().labels[axis];
  });
}

}  // namespace

std::map<std::string, fs::path> point_folders(const StudyFolder& folder) {
  std::map<std::string, fs::path> found;
  if (!fs::exists(folder.points())) return found;
  for (const auto& entry : fs::directory_iterator(folder.points())) {
    const std::string name = entry.path().filename().string();
    const auto dash = name.find('-');
    if (entry.is_directory() && dash != std::string::npos)
      found[name.substr(dash + 1)] = entry.path();
  }
  return found;
}

std::vector<fs::path> folders_of(const StudyFolder& folder, const StudyPlan& plan) {
  auto known = point_folders(folder);
  int last = 0;
  for (const auto& [hash, path] : known) last = std::max(last, number_of(path));
  std::vector<fs::path> campaigns;
  for (const StudyCampaign& campaign : plan.campaigns) {
    auto found = known.find(campaign.hash);
    if (found == known.end()) {
      found = known
                  .emplace(campaign.hash,
                           folder.points() / fmt::format("{:04}-{}", ++last, campaign.hash))
                  .first;
    } else if (const fs::path file = found->second / point_case;
               fs::exists(file) && read_file(file) != campaign.case_text) {
      throw InputError(fmt::format(
          "{}: this case was changed by hand and is no longer that of its folder's name; move the "
          "folder away, or vary the key in the study",
          file.string()));
    }
    campaigns.push_back(found->second);
  }
  return campaigns;
}

void keep_plan(const StudyFolder& folder, const StudyPlan& plan,
               const std::vector<fs::path>& campaigns) {
  if (fs::exists(folder.locked_study())) {
    if (const std::string base = base_case_in(folder.locked_study()); base != plan.base.name)
      throw InputError(fmt::format(
          "{}: this folder belongs to a study of the case `{}`, and {} starts from `{}`; give "
          "another folder with --out",
          folder.root.string(), base, plan.study.file.string(), plan.base.name));
  }
  make_folder(folder.points());
  for (std::size_t i = 0; i < campaigns.size(); ++i) {
    const fs::path file = campaigns[i] / point_case;
    if (fs::exists(file)) continue;
    make_folder(campaigns[i]);
    write_file(file, plan.campaigns[i].case_text);
  }
  publish(folder.locked_study(), locked_text(plan));
}

void link_by_value(const StudyFolder& folder, const StudyPlan& plan,
                   const std::vector<fs::path>& campaigns) {
  fs::remove_all(folder.by_value());
  for (std::size_t i = 0; i < campaigns.size(); ++i) {
    fs::path place = folder.by_value();
    const StudyCampaign& campaign = plan.campaigns[i];
    for (std::size_t axis = 0; axis < plan.study.axes.size(); ++axis)
      if (varies(plan, axis))
        place /= as_folder_name(fmt::format("{}={}", last_part(plan.study.axes[axis].key),
                                            plan.points[campaign.point].labels[axis]));
    if (plan.study.replicates > 1) place /= fmt::format("seed={}", campaign.seed);
    if (place == folder.by_value()) return;
    make_folder(place.parent_path());
    if (!fs::is_symlink(place))
      fs::create_directory_symlink(fs::relative(campaigns[i], place.parent_path()), place);
  }
}

}  // namespace millwear::orchestrator
