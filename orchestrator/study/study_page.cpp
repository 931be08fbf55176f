#include "orchestrator/study/study_page.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "mill/base/number_or_null.h"
#include "mill/base/text_template.h"
#include "orchestrator/campaign/run_folder.h"
#include "orchestrator/report/html_text.h"
#include "orchestrator/results/history.h"
#include "orchestrator/results/profiles.h"
#include "orchestrator/study/coverage.h"
#include "orchestrator/study/liner_impacts.h"
#include "orchestrator/study/study_page_parts.h"
#include "orchestrator/study/study_tables.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t profiles_shown = 6;
constexpr std::size_t most_courses = 60;
constexpr std::size_t fewest_for_coverage = 3;

Json nodes_json(const ProfileRow& profile) {
  Json nodes = Json::array();
  for (const auto& node : profile.nodes)
    nodes.push_back({std::round(1e5 * node.x()) / 1e5, std::round(1e5 * node.y()) / 1e5});
  return nodes;
}

/// A few profiles from new to worn.
Json profiles_json(const fs::path& results) {
  const auto profiles = read_profiles_csv(results / "profiles.csv");
  Json shown = Json::array();
  const std::size_t last = profiles.size() - 1;
  const std::size_t count = std::min(profiles_shown, profiles.size());
  for (std::size_t i = 0; i < count; ++i) {
    const ProfileRow& profile = profiles[count > 1 ? i * last / (count - 1) : 0];
    shown.push_back({{"hours", profile.operating_hours}, {"nodes", nodes_json(profile)}});
  }
  return shown;
}

/// Energies that hits on the new liner exceed, and how often: of the seven decades below the
/// greatest, where all that matters is.
Json impacts_json(const fs::path& results) {
  constexpr double shown = 1e-7;
  Json points = Json::array();
  const fs::path file = results / "spectra.csv";
  if (!fs::exists(file)) return points;
  const auto exceeded = liner_impacts(read_spectra_csv(file)).exceeded;
  for (const auto& [energy, hits_per_second] : exceeded)
    if (energy > shown * exceeded.back().energy) points.push_back({energy, hits_per_second});
  return points;
}

Json course_json(const StudyResults& results, std::size_t campaign) {
  const fs::path tables = RunFolder{results.folders[campaign]}.results();
  Json hours = Json::array();
  Json heights = Json::array();
  Json powers = Json::array();
  for (const HistoryRow& row : read_history_csv(tables / "history.csv")) {
    hours.push_back(row.operating_hours);
    heights.push_back(1e3 * row.lifter_height);
    powers.push_back(Json(number_or_null(1e-3 * row.power)));
  }
  return {{"point", results.plan.campaigns[campaign].point + 1},
          {"hours", hours},
          {"height_mm", heights},
          {"power_kw", powers},
          {"impacts", impacts_json(tables)},
          {"profiles", profiles_json(tables)}};
}

/// The first replicate of every point that is done; of many points those that are likeliest to be
/// the best, or the first.
std::vector<std::size_t> drawn_campaigns(const StudyResults& results) {
  std::vector<std::size_t> campaigns;
  std::size_t next = 0;
  for (std::size_t i = 0; i < results.plan.campaigns.size(); ++i) {
    const std::size_t point = results.plan.campaigns[i].point;
    if (point < next || !results.figures[i]) continue;
    campaigns.push_back(i);
    next = point + 1;
  }
  if (campaigns.size() <= most_courses) return campaigns;
  std::ranges::stable_sort(campaigns, std::greater<>(), [&](std::size_t campaign) {
    const double probability =
        results.points[results.plan.campaigns[campaign].point].probability_of_best;
    return std::isfinite(probability) ? probability : 0.0;
  });
  campaigns.resize(most_courses);
  std::ranges::sort(campaigns);
  return campaigns;
}

Json courses_json(const StudyResults& results) {
  Json courses = Json::array();
  for (const std::size_t campaign : drawn_campaigns(results))
    courses.push_back(course_json(results, campaign));
  return courses;
}

/// Of a study with one point: what its campaigns predict of their scatter at four ages.
Json coverage_json(const StudyResults& results) {
  Json rows = Json::array();
  std::vector<fs::path> runs;
  for (std::size_t i = 0; i < results.folders.size(); ++i)
    if (results.figures[i] && std::isfinite(results.figures[i]->life_hours))
      runs.push_back(results.folders[i]);
  if (results.plan.points.size() != 1 || runs.size() < fewest_for_coverage) return rows;
  for (const Coverage& row : coverage_of(seeds_of_runs(runs)))
    rows.push_back({{"measure", row.measure},
                    {"hours", Json(number_or_null(row.hours))},
                    {"mean", row.mean},
                    {"scatter", row.scatter},
                    {"predicted", row.predicted},
                    {"ratio", row.ratio},
                    {"ratio_error", row.ratio_error}});
  return rows;
}

}  // namespace

std::string study_html(const StudyResults& results, const ScriptLibrary& d3) {
  Json document = study_document(results);
  document["courses"] = courses_json(results);
  document["coverage"] = coverage_json(results);
  return filled_template(study_page_html, {{"title", html_text(results.plan.study.name)},
                                           {"style", std::string(study_page_style)},
                                           {"d3", d3.script},
                                           {"d3_licence", html_text(d3.licence)},
                                           {"script", std::string(study_page_script)},
                                           {"data", inside_script(document.dump())}});
}

}  // namespace millwear::orchestrator
