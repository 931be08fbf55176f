#include "mill/case_file/case_build.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "mill/case/case_units.h"
#include "mill/case_file/case_schema_check.h"
#include "mill/case_file/case_values.h"

namespace millwear {
namespace {

std::vector<double> build_reversals(const CaseTable& campaign, CaseProblems& problems) {
  const CaseValue* const value = campaign.find("reversal_hours");
  if (value == nullptr) return {};
  std::vector<double> times = real_values(campaign, "reversal_hours");
  const auto late = std::adjacent_find(times.begin(), times.end(), std::greater_equal<>());
  if (late != times.end()) {
    problems.add(
        value->line,
        fmt::format("`reversal_hours` is not in order ({} h stands before {} h); list each "
                    "reversal once, the first first",
                    *late, *(late + 1)));
  }
  for (double& time : times) time = time_from_hours(time);
  return times;
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
    Material material{text_value(*table, "name"), real_value(*table, "density_kg_per_m3"),
                      real_value(*table, "shear_modulus_pa"), real_value(*table, "poisson_ratio"),
                      optional_real(*table, "modulus_reduction")};
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
    const MaterialPair pair{first, second, real_value(*table, "sliding_friction"),
                            real_value(*table, "rolling_friction"),
                            real_value(*table, "restitution")};
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

std::optional<ErrorTarget> build_error_target(const CaseTable& dem) {
  constexpr double most_in_least = 4.0;
  const auto error = optional_real(dem, "target_relative_error");
  if (!error) return std::nullopt;
  return ErrorTarget{*error, optional_real(dem, "most_revolutions")
                                 .value_or(most_in_least * real_value(dem, "measure_revolutions"))};
}

std::optional<RankSplit> build_rank_split(const CaseTable& dem) {
  const auto split = optional_text(dem, "rank_split");
  if (!split) return std::nullopt;
  return *split == name_of(RankSplit::axis) ? RankSplit::axis : RankSplit::charge;
}

DemSettings build_dem(const CaseDocument& document) {
  const CaseTable defaults{"dem", 1, false, {}};
  const CaseTable* const written = document.find("dem");
  const CaseTable& dem = written == nullptr ? defaults : *written;
  constexpr double every_step = 1.0;
  constexpr double between_dumps = 20.0;
  const auto path =
      text_value(dem, "wall_contacts") == "dumps" ? ContactPath::dumps : ContactPath::recorder;
  return {.modulus_reduction = real_value(dem, "modulus_reduction"),
          .rayleigh_fraction = real_value(dem, "rayleigh_fraction"),
          .longest_time_step = optional_real(dem, "longest_time_step_s"),
          .rolling_friction = text_value(dem, "rolling_friction_model") == "cdt"
                                  ? RollingFriction::cdt
                                  : RollingFriction::epsd2,
          .mix_revolutions = real_value(dem, "mix_revolutions"),
          .settle_pitches = integer_value(dem, "settle_pitches"),
          .measure_revolutions = real_value(dem, "measure_revolutions"),
          .contact_path = path,
          .sample_every_steps = static_cast<int>(
              optional_real(dem, "sample_every_steps")
                  .value_or(path == ContactPath::recorder ? every_step : between_dumps)),
          .ranks = integer_value(dem, "ranks"),
          .skin = optional_real(dem, "skin_m"),
          .rank_split = build_rank_split(dem),
          .mesh_tolerance = real_value(dem, "mesh_tolerance"),
          .seed = static_cast<std::uint64_t>(integer_value(dem, "seed")),
          .keep_dumps = boolean_value(dem, "keep_dumps"),
          .keep_events = boolean_value(dem, "keep_events"),
          .pair_revolutions = real_value(dem, "pair_revolutions"),
          .time_step = optional_real(dem, "time_step_s"),
          .error_target = build_error_target(dem),
          .tune = boolean_value(dem, "tune"),
          .mix_until_steady = boolean_value(dem, "mix_until_steady")};
}

CampaignSettings build_campaign(const CaseDocument& document, CaseProblems& problems) {
  const CaseTable& campaign = *document.find("campaign");
  const double plate_thickness = real_value(*document.find("lifter"), "plate_thickness_m");
  return {
      .threshold = real_value(campaign, "threshold"),
      .steps_per_cycle = integer_value(campaign, "steps_per_cycle"),
      .height_limit = real_value(campaign, "height_limit_m"),
      .plate_limit = optional_real(campaign, "plate_limit_m").value_or(0.1 * plate_thickness),
      .cycle_limit = integer_value(campaign, "cycle_limit"),
      .scheme = text_value(campaign, "scheme") == "adaptive" ? Scheme::adaptive : Scheme::threshold,
      .step_tolerance = real_value(campaign, "step_tolerance"),
      .largest_share = real_value(campaign, "largest_share"),
      .reversal_times = build_reversals(campaign, problems)};
}

GaugeSettings build_gauge(const CaseDocument& document) {
  const CaseTable* const gauge = document.find("gauge");
  if (gauge == nullptr) return {};
  return {.calibrate_until = optional_real(*gauge, "calibrate_until_hours")};
}

double build_speed(const CaseDocument& document, const LinerSector& sector, double largest_diameter,
                   CaseProblems& problems) {
  const CaseTable& mill = *document.find("mill");
  const std::optional<double> rpm = optional_real(mill, "speed_rpm");
  const std::optional<double> fraction = optional_real(mill, "critical_speed_fraction");
  if (rpm.has_value() == fraction.has_value()) {
    problems.add(mill.line,
                 fmt::format("[mill] has {} `speed_rpm` {} `critical_speed_fraction`; give one of "
                             "the two",
                             rpm ? "both" : "neither", rpm ? "and" : "nor"));
    return 1.0;
  }
  if (rpm) {
    return speed_from_rpm(*rpm);
  }
  const double speed = *fraction * critical_speed(sector, largest_diameter);
  return speed_from_rpm(speed / speed_from_rpm(1.0));
}

}  // namespace millwear
