#include "mill/case_file/case_build.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "mill/base/nearest_word.h"
#include "mill/case/case_units.h"
#include "mill/case_file/case_values.h"
#include "mill/case_keys/campaign_keys.h"
#include "mill/case_keys/charge_keys.h"
#include "mill/case_keys/dem_keys.h"

namespace millwear {
namespace {

void check_reversals(const CaseTable& campaign, CaseProblems& problems) {
  const CaseValue* const value = campaign.find("reversal_hours");
  if (value == nullptr) return;
  const std::vector<double> hours = numbers_in(*value);
  const auto late = std::adjacent_find(hours.begin(), hours.end(), std::greater_equal<>());
  if (late != hours.end()) {
    problems.add(
        value->line,
        fmt::format("`reversal_hours` is not in order ({} h stands before {} h); list each "
                    "reversal once, the first first",
                    *late, *(late + 1)));
  }
}

}  // namespace

std::size_t material_index(const std::vector<Material>& materials, const CaseTable& table,
                           std::string_view key, std::string_view name, CaseProblems& problems) {
  const auto found = std::find_if(materials.begin(), materials.end(),
                                  [name](const Material& m) { return m.name == name; });
  if (found != materials.end()) {
    return static_cast<std::size_t>(found - materials.begin());
  }
  std::vector<std::string_view> known;
  for (const Material& material : materials) {
    known.push_back(material.name);
  }
  const std::string near = nearest_word(name, known);
  problems.add(table.find(key)->line,
               fmt::format("no [[materials]] has the name `{}`; {}", name,
                           near.empty() ? "add one" : fmt::format("did you mean `{}`?", near)));
  return 0;
}

std::vector<Material> build_materials(const CaseDocument& document, CaseProblems& problems) {
  std::vector<Material> materials;
  for (const CaseTable* table : document.all("materials")) {
    Material material{};
    read_keys(material_keys(), table, material);
    if (std::any_of(materials.begin(), materials.end(),
                    [&](const Material& m) { return m.name == material.name; })) {
      problems.add(table->find("name")->line,
                   fmt::format("two materials are called `{}`; rename one", material.name));
    }
    materials.push_back(std::move(material));
  }
  return materials;
}

std::vector<MaterialPair> build_pairs(const CaseDocument& document,
                                      const std::vector<Material>& materials,
                                      CaseProblems& problems) {
  std::vector<MaterialPair> pairs;
  for (const CaseTable* table : document.all("pairs")) {
    const std::vector<std::string> names = text_values(*table, "materials");
    const auto [first, second] =
        std::minmax({material_index(materials, *table, "materials", names[0], problems),
                     material_index(materials, *table, "materials", names[1], problems)});
    MaterialPair pair{first, second, 0.0, 0.0, 0.0};
    read_keys(pair_keys(), table, pair);
    if (problems.empty() && std::any_of(pairs.begin(), pairs.end(), [&](const MaterialPair& p) {
          return p.first == pair.first && p.second == pair.second;
        })) {
      problems.add(
          table->find("materials")->line,
          fmt::format("the pair of `{}` and `{}` is given twice; delete one", names[0], names[1]));
    }
    pairs.push_back(pair);
  }
  return pairs;
}

DemSettings build_dem(const CaseDocument& document) {
  DemSettings dem;
  const CaseTable* const table = document.find("dem");
  read_keys(dem_keys(), table, dem);
  const bool is_free = table != nullptr && table->find("mix_until_steady") == nullptr;
  if (dem.charge_from && is_free && dem.contact_path == ContactPath::recorder)
    dem.mix_until_steady = true;
  return dem;
}

CampaignSettings build_campaign(const CaseDocument& document, CaseProblems& problems) {
  const CaseTable& table = *document.find("campaign");
  const double plate_thickness = real_value(*document.find("lifter"), "plate_thickness_m");
  CampaignSettings campaign{};
  campaign.plate_limit = 0.1 * plate_thickness;
  read_keys(campaign_keys(), &table, campaign);
  check_reversals(table, problems);
  return campaign;
}

GaugeSettings build_gauge(const CaseDocument& document) {
  GaugeSettings gauge;
  read_keys(gauge_keys(), document.find("gauge"), gauge);
  return gauge;
}

double build_speed(const CaseDocument& document, const Case& mill, CaseProblems& problems) {
  const CaseTable& table = *document.find("mill");
  const bool rpm = table.find("speed_rpm") != nullptr;
  const std::optional<double> fraction = optional_real(table, "critical_speed_fraction");
  if (rpm == fraction.has_value()) {
    problems.add(table.line,
                 fmt::format("[mill] has {} `speed_rpm` {} `critical_speed_fraction`; give one of "
                             "the two",
                             rpm ? "both" : "neither", rpm ? "and" : "nor"));
    return 1.0;
  }
  if (rpm) return mill.speed;
  const double speed = *fraction * critical_speed(mill.liner.sector, largest_diameter(mill));
  return speed_from_rpm(speed / speed_from_rpm(1.0));
}

}  // namespace millwear
