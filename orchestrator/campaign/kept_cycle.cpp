#include "orchestrator/campaign/kept_cycle.h"

#include <nlohmann/json.hpp>

#include "mill/base/versioned_json.h"
#include "mill/base/whole_file.h"

namespace millwear::orchestrator {
namespace {

constexpr int steps_version = 1;
using nlohmann::json;

json nodes_json(const LinerProfile& profile) {
  json nodes = json::array();
  for (const auto& node : profile.nodes) nodes.push_back({node.x(), node.y()});
  return nodes;
}

LinerProfile profile_from(const json& nodes, const LinerSector& sector) {
  LinerProfile profile{sector, {}};
  for (const auto& node : nodes)
    profile.nodes.emplace_back(node.at(0).get<double>(), node.at(1).get<double>());
  return profile;
}

}  // namespace

void write_cycle(const std::filesystem::path& file, const KeptCycle& cycle) {
  json steps = json::array();
  for (const auto& step : cycle.steps)
    steps.push_back({{"duration_s", step.duration},
                     {"removed_area_m2", step.removed_area},
                     {"accounted_area_m2", step.accounted_area},
                     {"fallen_area_m2", step.fallen_area},
                     {"nodes_m", nodes_json(step.profile)}});
  const json document = {{"type", "millwear geometry steps"},
                         {"format_version", steps_version},
                         {"smoothing_moved_share", cycle.smoothing_moved_share},
                         {"worn_by_load_m2_per_s", cycle.worn_by_load},
                         {"steps", steps}};
  write_file(file, document.dump() + "\n");
}

KeptCycle read_cycle(const std::filesystem::path& file, const LinerSector& sector) {
  return read_versioned_json(
      file, "millwear geometry steps", steps_version, [&](const json& document) {
        KeptCycle cycle{document.at("smoothing_moved_share").get<double>(),
                        document.at("worn_by_load_m2_per_s").get<double>(),
                        {}};
        for (const auto& step : document.at("steps"))
          cycle.steps.push_back(
              {step.at("duration_s").get<double>(), step.at("removed_area_m2").get<double>(),
               step.at("accounted_area_m2").get<double>(), step.at("fallen_area_m2").get<double>(),
               profile_from(step.at("nodes_m"), sector)});
        return cycle;
      });
}

}  // namespace millwear::orchestrator
