#include "liggghts_inputs/decks/deck.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "deck_templates.h"
#include "mill/base/text_template.h"
#include "mill/liner/profile_measures.h"
#include "mill/load/steady_mixing.h"

namespace millwear::liggghts {
namespace {

constexpr int thermo_lines = 200;

std::string number(double value) { return fmt::format("{}", value); }

template <class Property>
std::string by_material(const Case& mill, Property property) {
  std::vector<double> values;
  for (std::size_t m = 0; m < mill.materials.size(); ++m) values.push_back(property(m));
  return fmt::format("{}", fmt::join(values, " "));
}

/// LIGGGHTS wants every pair; one that the case leaves out never touches, and any value will do.
template <class Property>
std::string by_pair(const Case& mill, Property property) {
  std::vector<double> values;
  for (std::size_t a = 0; a < mill.materials.size(); ++a)
    for (std::size_t b = 0; b < mill.materials.size(); ++b) {
      const auto found = std::ranges::find_if(mill.pairs, [&](const MaterialPair& pair) {
        return (pair.first == a && pair.second == b) || (pair.first == b && pair.second == a);
      });
      values.push_back(property(found == mill.pairs.end() ? mill.pairs.front() : *found));
    }
  return fmt::format("{}", fmt::join(values, " "));
}

/// A contact may overlap the wall, and the mesh may stand out of the profile by its tolerance.
std::string near_wall_radius(const Case& mill, const LinerProfile& worn) {
  const double margin = 0.02 * largest_diameter(mill) + mesh_tolerance(mill);
  return number(crest_radius(worn) - 0.5 * largest_diameter(mill) - margin);
}

std::string dump_computes(const Case& mill, const LinerProfile& worn) {
  if (mill.dem.contact_path == ContactPath::recorder) return "";
  return filled_template(dump_computes_template,
                         {{"near_wall_radius_m", near_wall_radius(mill, worn)}});
}

std::string dumps(const Case& mill, const StretchSteps& steps) {
  if (mill.dem.contact_path == ContactPath::recorder)
    return "# millwear-recorder sees the wall contacts of the steps to come from inside.\n";
  return filled_template(dumps_template, {{"sample_steps", fmt::format("{}", steps.sample_steps)},
                                          {"last_step", fmt::format("{}", steps.total())},
                                          {"contacts_file", file_names::contacts},
                                          {"spins_file", file_names::spins}});
}

std::string liner_id(const MeshInMill& mesh) {
  constexpr std::array<std::string_view, 3> suffixes = {"_mix", "_trial", ""};
  return fmt::format("liner_{:03}{}{}", mesh.cycle, suffixes[static_cast<std::size_t>(mesh.kind)],
                     mesh.chunk > 0 ? fmt::format("_chunk_{}", mesh.chunk) : "");
}

std::string drift(const Case& mill) {
  if (!mill.dem.mix_until_steady) return "";
  const MixingPlan plan = mixing_plan(mill, plan_steps(mill));
  return fmt::format(
      "# millwear-recorder mix ends this run once these means over whole pitches drift no longer;\n"
      "# the plain liggghts takes it to its end.\n"
      "fix           drift all ave/time 1 {0} {0} v_torque c_kinetic\n",
      plan.piece);
}

std::string rank_grid(const Case& mill, int ranks) {
  const int columns = rank_columns(mill, ranks);
  if (rank_split(mill, ranks) == RankSplit::balanced)
    return fmt::format("{} {} 1", columns, ranks / columns);
  return fmt::format("{} * 1", columns);
}

/// Balanced columns are cut before every run: for the packed charge, and for the turning one.
std::string mix_runs(const Case& mill, const StretchSteps& steps, int ranks) {
  const StepPlan plan = plan_steps(mill);
  const long falling = (mill.liner.sector.rows + 3) / 4 * plan.steps_per_pitch;
  if (!columns_to_balance(mill, ranks) || mill.dem.mix_until_steady || steps.total() <= falling)
    return fmt::format("run           {}", steps.total());
  return fmt::format("run           {}\nrun           {}", falling, steps.total() - falling);
}

std::string measure_runs(const StretchSteps& steps) {
  if (steps.pair_steps == 0) return fmt::format("run           {}", steps.measure_steps);
  if (steps.pair_steps == steps.measure_steps)
    return fmt::format("run           {}", steps.pair_steps);
  return fmt::format(
      "run           {}\n# ... and from here on the collisions between particles too.\n"
      "run           {}",
      steps.measure_steps - steps.pair_steps, steps.pair_steps);
}

}  // namespace

double neighbour_skin(const Case& mill) {
  if (mill.dem.skin) return *mill.dem.skin;
  return 0.5 * smallest_diameter(mill);
}

// Along the axis the charge is even, but slabs thinner than the largest particle have mostly ghosts
// in them: cut through the charge they are better shared in most mills.
RankSplit rank_split(const Case& mill, int ranks) {
  const RankSplit split = mill.dem.rank_split.value_or(RankSplit::charge);
  return split == RankSplit::charge && ranks % 2 == 1 ? RankSplit::axis : split;
}

int rank_columns(const Case& mill, int ranks) {
  const RankSplit split = rank_split(mill, ranks);
  if (split != RankSplit::balanced) return split == RankSplit::charge ? 2 : 1;
  const double width = 2.0 * mill.liner.sector.plate_radius;
  const auto surface = [&](int columns) {
    return columns / width + static_cast<double>(ranks) / columns / mill.slice_length;
  };
  int best = ranks;
  for (int columns = 1; columns < ranks; ++columns)
    if (ranks % columns == 0 && surface(columns) < surface(best)) best = columns;
  return best;
}

std::optional<long> columns_to_balance(const Case& mill, int ranks) {
  if (ranks == 1 || rank_split(mill, ranks) != RankSplit::balanced) return std::nullopt;
  return rank_columns(mill, ranks);
}

std::string contact_model_deck(const Case& mill, const StretchSteps& steps,
                               const LinerMeshFile& mesh, const MeshInMill& which) {
  std::vector<std::string> names;
  for (const auto& material : mill.materials) names.push_back(material.name);
  const auto youngs_modulus = [&](std::size_t m) {
    return 2.0 * softened_shear_modulus(mill, m) * (1.0 + mill.materials[m].poisson_ratio);
  };
  const bool cdt = mill.dem.rolling_friction == RollingFriction::cdt;
  return filled_template(
      contact_model_template,
      {{"modulus_reductions",
        by_material(mill, [&](std::size_t m) { return modulus_reduction(mill, m); })},
       {"material_names", fmt::format("{}", fmt::join(names, " "))},
       {"material_count", fmt::format("{}", mill.materials.size())},
       {"youngs_moduli", by_material(mill, youngs_modulus)},
       {"poisson_ratios",
        by_material(mill, [&](std::size_t m) { return mill.materials[m].poisson_ratio; })},
       {"restitutions", by_pair(mill, [](const MaterialPair& p) { return p.restitution; })},
       {"sliding_frictions",
        by_pair(mill, [](const MaterialPair& p) { return p.sliding_friction; })},
       {"rolling_frictions",
        by_pair(mill, [](const MaterialPair& p) { return p.rolling_friction; })},
       {"rolling_friction_model", cdt ? "cdt" : "epsd2"},
       {"time_step_s", number(steps.time_step)},
       {"liner_id", liner_id(which)},
       {"stl_file", mesh.stl_file},
       {"liner_type", fmt::format("{}", mill.liner_material + 1)},
       {"period_s", number(2.0 * std::numbers::pi / mill.speed)}});
}

std::string mixing_deck(const Case& mill, const StretchSteps& steps,
                        const std::optional<std::string>& previous_restart, int ranks) {
  return filled_template(
      mix_template,
      {{"case_name", mill.name},
       {"rank_grid", rank_grid(mill, ranks)},
       {"read_charge", previous_restart ? fmt::format("read_restart  {}", *previous_restart)
                                        : fmt::format("read_data     {}", file_names::charge)},
       {"skin_m", number(neighbour_skin(mill))},
       {"contact_model_file", file_names::contact_model},
       {"thermo_steps", fmt::format("{}", std::max(1L, steps.total() / thermo_lines))},
       {"drift", drift(mill)},
       {"mix_runs", mix_runs(mill, steps, ranks)},
       {"restart_file", file_names::restart},
       {"sentinel", std::string(sentinel)}});
}

std::string measuring_deck(const Case& mill, const StretchSteps& steps, const LinerProfile& worn,
                           const std::string& previous_restart, int ranks) {
  return filled_template(
      measure_template,
      {{"case_name", mill.name},
       {"rank_grid", rank_grid(mill, ranks)},
       {"previous_restart_file", previous_restart},
       {"skin_m", number(neighbour_skin(mill))},
       {"contact_model_file", file_names::contact_model},
       {"dump_computes", dump_computes(mill, worn)},
       {"thermo_steps", fmt::format("{}", std::max(1L, steps.total() / thermo_lines))},
       {"settle_steps", fmt::format("{}", steps.settle_steps)},
       {"dumps", dumps(mill, steps)},
       {"torque_steps", fmt::format("{}", steps.torque_interval())},
       {"torque_file", file_names::torque},
       {"measure_runs", measure_runs(steps)},
       {"restart_file", file_names::restart},
       {"sentinel", std::string(sentinel)}});
}

std::string charge_reading_deck(const std::string& restart_file, const std::string& charge_file) {
  return filled_template(read_charge_template, {{"restart_file", restart_file},
                                                {"charge_file", charge_file},
                                                {"sentinel", std::string(sentinel)}});
}

std::string trial_deck(const Case& mill, const TrialSteps& steps,
                       const std::string& previous_restart, int ranks) {
  return filled_template(trial_template, {{"case_name", mill.name},
                                          {"rank_grid", rank_grid(mill, ranks)},
                                          {"previous_restart_file", previous_restart},
                                          {"skin_m", number(neighbour_skin(mill))},
                                          {"contact_model_file", file_names::contact_model},
                                          {"thermo_steps", fmt::format("{}", steps.total())},
                                          {"warm_up_steps", fmt::format("{}", steps.warm_up)},
                                          {"timed_steps", fmt::format("{}", steps.timed)},
                                          {"sentinel", std::string(sentinel)}});
}

}  // namespace millwear::liggghts
