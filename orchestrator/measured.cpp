#include "orchestrator/measured.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "mill/failure.h"

namespace millwear::orchestrator {
namespace {

constexpr int format_version = 1;
using nlohmann::json;

/// JSON has no NaN: null stands for it.
json number(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }
double number_from(const json& value) {
  return value.is_null() ? std::nan("") : value.get<double>();
}

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

template <class Parse>
auto parsed(const std::filesystem::path& file, std::string_view type, Parse parse) {
  try {
    const json document = json::parse(read_file(file));
    if (document.at("type").get<std::string>() != type ||
        document.at("format_version").get<int>() != format_version)
      throw ResultRejected(fmt::format("it is not a {} of version {}", type, format_version));
    return parse(document);
  } catch (const DiskError&) {
    throw;
  } catch (const std::exception& problem) {
    throw ResultRejected(fmt::format("{}: {}", file.string(), problem.what()));
  }
}

}  // namespace

void write_measured(const std::filesystem::path& file, const Measured& measured) {
  const json document = {{"type", "millwear measured"},
                         {"format_version", format_version},
                         {"power_w", measured.power},
                         {"power_w_se", number(measured.power_error)},
                         {"power_times_s", measured.power_times},
                         {"power_series_w", measured.power_series},
                         {"toe_rad", number(measured.charge.toe)},
                         {"toe_rad_se", number(measured.charge.toe_error)},
                         {"shoulder_rad", number(measured.charge.shoulder)},
                         {"shoulder_rad_se", number(measured.charge.shoulder_error)},
                         {"samples", measured.samples},
                         {"rejected_share", measured.rejected_share}};
  write_file(file, document.dump(1) + "\n");
}

Measured read_measured(const std::filesystem::path& file) {
  return parsed(file, "millwear measured", [](const json& document) {
    return Measured{
        document.at("power_w").get<double>(),
        number_from(document.at("power_w_se")),
        document.at("power_times_s").get<std::vector<double>>(),
        document.at("power_series_w").get<std::vector<double>>(),
        {number_from(document.at("toe_rad")), number_from(document.at("toe_rad_se")),
         number_from(document.at("shoulder_rad")), number_from(document.at("shoulder_rad_se"))},
        document.at("samples").get<long>(),
        document.at("rejected_share").get<double>()};
  });
}

void write_cycle(const std::filesystem::path& file, const KeptCycle& cycle) {
  json steps = json::array();
  for (const auto& step : cycle.steps)
    steps.push_back({{"duration_s", step.duration},
                     {"removed_area_m2", step.removed_area},
                     {"accounted_area_m2", step.accounted_area},
                     {"fallen_area_m2", step.fallen_area},
                     {"nodes_m", nodes_json(step.profile)}});
  const json document = {{"type", "millwear geometry steps"},
                         {"format_version", format_version},
                         {"smoothing_moved_share", cycle.smoothing_moved_share},
                         {"worn_by_load_m2_per_s", cycle.worn_by_load},
                         {"steps", steps}};
  write_file(file, document.dump() + "\n");
}

KeptCycle read_cycle(const std::filesystem::path& file, const LinerSector& sector) {
  return parsed(file, "millwear geometry steps", [&](const json& document) {
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

void write_file(const std::filesystem::path& file, std::string_view text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw DiskError(fmt::format("{}: cannot be written; is the disk full?", file.string()));
}

std::string read_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  if (!in) throw DiskError(fmt::format("{}: cannot be read", file.string()));
  return text.str();
}

}  // namespace millwear::orchestrator
