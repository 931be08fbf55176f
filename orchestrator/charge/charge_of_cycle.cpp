#include "orchestrator/charge/charge_of_cycle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "mill/base/constants.h"
#include "mill/base/contract.h"
#include "mill/liner/profile_measures.h"
#include "wear/charge/charge_record.h"

namespace millwear::orchestrator {
namespace {

std::filesystem::path charge_file(const Campaign& campaign, int cycle) {
  return campaign.folder.stage({cycle, StageKind::dem}) / stage_files::charge;
}

/// Mean of what the classes of a cell have, by their mass there.
Eigen::VectorXd class_mean(const wear::FieldMap& map, const Eigen::VectorXd& of_class) {
  return map.class_share * of_class;
}

std::vector<SectionMap> maps_of(const Case& mill, const wear::ChargeFields& fields) {
  const auto map = wear::map_of(fields);
  std::vector<SectionMap> maps{{"occupied", "1", map.occupied},
                               {"velocity_x", "m/s", map.velocity_x},
                               {"velocity_z", "m/s", map.velocity_z},
                               {"temperature", "m2/s2", map.temperature}};
  if (fields.pair_duration > 0.0) {
    maps.push_back({"normal_power", "W/m3", wear::averaged(fields.grid, map.normal_power)});
    maps.push_back({"shear_power", "W/m3", wear::averaged(fields.grid, map.shear_power)});
  }
  const auto& classes = mill.charge.classes;
  Eigen::VectorXd of_class(std::ssize(classes));
  std::ranges::transform(classes, of_class.begin(), &ParticleClass::diameter);
  maps.push_back({"mean_diameter", "m", class_mean(map, of_class)});
  for (std::size_t material = 0; material < mill.materials.size(); ++material) {
    std::ranges::transform(classes, of_class.begin(), [&](const ParticleClass& one) {
      return one.material == material ? 1.0 : 0.0;
    });
    if (of_class.sum() > 0.0 && of_class.sum() < static_cast<double>(of_class.size()))
      maps.push_back({"share_of_" + mill.materials[material].name, "1", class_mean(map, of_class)});
  }
  return maps;
}

/// A circle of the charge that the crests just do not touch.
double inside_the_crests(const LinerProfile& liner, const wear::SectionGrid& grid) {
  return crest_radius(liner) - grid.cell_size();
}

double scale_of_speeds(double diameter) {
  const double fall = 0.75 * std::sqrt(2.0 * standard_gravity * diameter);
  return fall > 4.0 ? std::round(fall) : std::round(2.0 * fall) / 2.0;
}

ShownCharge charge_of(const Case& mill) {
  ShownCharge shown{.classes = {},
                    .slice_length = mill.slice_length,
                    .fastest = scale_of_speeds(2.0 * mill.liner.sector.shell_radius),
                    .cycles = {}};
  for (const ParticleClass& one : mill.charge.classes) {
    const Material& material = mill.materials[one.material];
    shown.classes.push_back({fmt::format("{} {:g} mm", material.name, 1e3 * one.diameter),
                             material.name, one.diameter, material.density});
  }
  return shown;
}

}  // namespace

ShownCharge charge_of_cycles(const Campaign& campaign, const std::vector<int>& cycles) {
  ShownCharge shown = charge_of(campaign.mill);
  std::vector<int> found;
  for (const int cycle : cycles)
    if (std::filesystem::exists(charge_file(campaign, cycle))) found.push_back(cycle);
  if (found.empty()) return shown;
  const std::set<int> with_frames{found.front(), found[found.size() / 2], found.back()};
  for (const int cycle : found) {
    const auto parts =
        with_frames.contains(cycle) ? wear::ChargeParts::all : wear::ChargeParts::fields;
    auto record = wear::read_charge(charge_file(campaign, cycle), parts);
    const LinerProfile liner = dem_liner_of_cycle(campaign, cycle);
    shown.cycles.push_back(
        {cycle, as_operated(campaign, cycle).mill.speed, liner, record.fields.grid,
         maps_of(campaign.mill, record.fields),
         wear::landmarks_of(record.fields, inside_the_crests(liner, record.fields.grid)),
         std::move(record.frames)});
  }
  return shown;
}

const SectionMap& map_named(const ChargeOfCycle& charge, std::string_view name) {
  const auto found = std::ranges::find(charge.maps, name, &SectionMap::name);
  expect(found != charge.maps.end(), "the charge has a map of this name");
  return *found;
}

}  // namespace millwear::orchestrator
