#include "orchestrator/app/check_verb.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "liggghts_inputs/decks/stretch.h"
#include "mill/base/constants.h"
#include "mill/base/number_or_null.h"
#include "mill/case/operated_mill.h"
#include "mill/case_file/case_build_liner.h"
#include "mill/case_file/case_file.h"
#include "mill/case_file/case_warnings.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/app/draw_verb.h"
#include "orchestrator/campaign/mesh_files.h"
#include "orchestrator/campaign/open_campaign.h"
#include "orchestrator/campaign/output_path.h"
#include "orchestrator/dem_run/charge_source.h"
#include "orchestrator/dem_run/cost_estimate.h"
#include "orchestrator/dem_run/rank_cost.h"
#include "orchestrator/drawing/drawn_liner_reader.h"

namespace millwear::orchestrator {
namespace {

nlohmann::json check_json(const Case& mill, int ranks) {
  const auto plan = plan_steps(mill);
  const auto cost = estimate_cost(mill, ranks);
  const auto charge = totals(mill);
  const auto measuring = liggghts::measuring_steps(mill, plan);
  nlohmann::json classes = nlohmann::json::array();
  for (const auto& kind : mill.charge.classes)
    classes.push_back({{"material", mill.materials[kind.material].name},
                       {"diameter_m", kind.diameter},
                       {"count", kind.count}});
  return {{"case", mill.name},
          {"classes", classes},
          {"particles", charge.particles},
          {"solid_volume_m3", charge.solid_volume},
          {"mass_kg", charge.mass},
          {"filling_computed", filling_inside_plate(mill)},
          {"filling_declared", number_or_null(mill.charge.declared.total)},
          {"ball_filling_declared", number_or_null(mill.charge.declared.balls)},
          {"speed_rpm", mill.speed * 30.0 / std::numbers::pi},
          {"critical_speed_fraction", critical_speed_fraction(mill)},
          {"lifter_height_m", lifter_height(mill.liner)},
          {"rayleigh_time_s", shortest_rayleigh_time(mill)},
          {"time_step_s", plan.time_step},
          {"steps_per_revolution", plan.steps_per_revolution(mill.liner.sector.rows)},
          {"wall_contacts", name_of(mill.dem.contact_path)},
          {"sample_every_steps", mill.dem.sample_every_steps},
          {"mixing_steps", liggghts::mixing_steps(mill, plan).total()},
          {"mix_until_steady", mill.dem.mix_until_steady},
          {"steps_per_cycle", measuring.total()},
          {"most_steps_per_cycle", measuring.most_total()},
          {"target_relative_error", mill.dem.error_target
                                        ? nlohmann::json(mill.dem.error_target->relative_error)
                                        : nlohmann::json(nullptr)},
          {"ranks", ranks},
          {"mixing_seconds", cost.mixing},
          {"cycle_seconds", cost.per_cycle},
          {"most_cycle_seconds", cost.per_cycle_most},
          {"operation", spoken_operation(mill)},
          {"warnings", warnings(mill)}};
}

std::string spoken_contact_path(const Case& mill) {
  const int every = mill.dem.sample_every_steps;
  const std::string when = every == 1 ? "every step" : fmt::format("every {} steps", every);
  return mill.dem.contact_path == ContactPath::recorder
             ? when + ", recorded from inside LIGGGHTS"
             : when + ", sampled through the dumps of the plain liggghts";
}

std::string spoken_target(const Case& mill, const StepPlan& plan,
                          const liggghts::StretchSteps& measuring) {
  const auto revolutions = [&](long steps) {
    return static_cast<double>(steps) /
           static_cast<double>(plan.steps_per_revolution(mill.liner.sector.rows));
  };
  return fmt::format(
      "a measurement ends once its rate is known to {:g} % at its peaks: after {:.4g} revolutions, "
      "or {:.4g} more at a time, up to {:.4g}",
      100.0 * mill.dem.error_target->relative_error, revolutions(measuring.measure_steps),
      revolutions(measuring.go_on_steps), revolutions(measuring.most_measure_steps));
}

void print_charge(const Case& mill) {
  fmt::print("Charge\n");
  for (const auto& kind : mill.charge.classes)
    fmt::print("  {:>10} of {:6.1f} mm {:>9}\n", kind.count, 1e3 * kind.diameter,
               mill.materials[kind.material].name);
  const auto charge = totals(mill);
  fmt::print("  {:>10} particles, {:.3f} m3 solid, {:.2f} t in the slice\n", charge.particles,
             charge.solid_volume, charge.mass / kilograms_per_tonne);
  fmt::print("  filling   {:.1f} % computed from the counts", 100.0 * filling_inside_plate(mill));
  if (mill.charge.declared.total)
    fmt::print(", {:.1f} % declared", 100.0 * *mill.charge.declared.total);
  if (mill.charge.declared.balls)
    fmt::print(" (balls {:.1f} % declared)", 100.0 * *mill.charge.declared.balls);
  fmt::print("\n");
}

void print_operation(const Case& mill) {
  const auto& changes = mill.campaign.operation;
  if (changes.empty()) return;
  fmt::print("Operation\n");
  for (const auto& sentence : spoken_operation(mill)) fmt::print("  {}\n", sentence);
  fmt::print("  {} of {} changes ask for a new mixing and at least one more cycle\n",
             std::ranges::count_if(changes, asks_for_load), changes.size());
}

/// What of a drawn liner's drawing is left out.
void print_left_out(const Case& mill) {
  const auto drawn = drawn_liner_in(read_case_document(mill.file));
  if (!drawn) return;
  for (const std::string& left : left_out_of(*drawn))
    fmt::print("  left out of {}: {}\n", drawn->file.filename().string(), left);
}

void print_check(const Case& mill, int ranks) {
  const auto& sector = mill.liner.sector;
  const auto plan = plan_steps(mill);
  const auto mixing = liggghts::mixing_steps(mill, plan);
  const auto measuring = liggghts::measuring_steps(mill, plan);
  const auto cost = estimate_cost(mill, ranks);
  fmt::print("{}: {:g} m inside the shell, {:g} m inside the new liner, slice of {:g} m\n",
             mill.name, 2.0 * sector.shell_radius, 2.0 * sector.plate_radius, mill.slice_length);
  fmt::print(
      "Liner\n  {} lifters {:.1f} mm high, leading face {:.1f} deg off upright, plate {:.1f} mm\n",
      sector.rows, 1e3 * lifter_height(mill.liner),
      leading_face_angle(mill.liner) / radians_per_degree, 1e3 * plate_thickness(mill.liner));
  print_left_out(mill);
  fmt::print("Speed\n  {:.2f} rpm, {:.1f} % of critical\n", mill.speed * 30.0 / std::numbers::pi,
             100.0 * critical_speed_fraction(mill));
  print_charge(mill);
  print_operation(mill);
  fmt::print("DEM\n  time step {:.3e} s, {:.0f} % of the shortest Rayleigh time {:.3e} s\n",
             plan.time_step, 100.0 * plan.time_step / shortest_rayleigh_time(mill),
             shortest_rayleigh_time(mill));
  const auto range = [](const std::string& least, const std::string& most) {
    return least == most ? least : least + " to " + most;
  };
  const char* const at_most = mill.dem.mix_until_steady ? "at most " : "";
  fmt::print("  {} steps a revolution; mixing {}{} steps, each cycle {} steps\n",
             plan.steps_per_revolution(sector.rows), at_most, mixing.total(),
             range(std::to_string(measuring.total()), std::to_string(measuring.most_total())));
  if (mill.dem.error_target) fmt::print("  {}\n", spoken_target(mill, plan, measuring));
  fmt::print("  on {} ranks {}about {} to mix and {} a cycle (within a factor of three)\n", ranks,
             at_most, spoken_time(cost.mixing),
             range(spoken_time(cost.per_cycle), spoken_time(cost.per_cycle_most)));
  fmt::print("  wall contacts {}\n", spoken_contact_path(mill));
  for (const auto& warning : warnings(mill)) fmt::print("Warning: {}\n", warning);
}

/// The least efficiency of a number of ranks that is recommended.
constexpr double least_efficiency = 0.6;

/// Costs of a campaign on so many ranks, against one.
struct RankChoice {
  RankCost cost;
  double seconds;     ///< of a campaign
  double efficiency;  ///< time on one rank over the core time on these
};

std::vector<RankChoice> rank_choices(const Case& mill, const std::vector<int>& ranks) {
  const double alone = campaign_seconds(mill, estimate_cost(mill, 1));
  std::vector<RankChoice> choices;
  for (const int count : ranks) {
    const double seconds = campaign_seconds(mill, estimate_cost(mill, count));
    choices.push_back({rank_cost(mill, count), seconds, alone / (count * seconds)});
  }
  return choices;
}

/// The fastest that uses its cores well enough.
const RankChoice* recommended(const std::vector<RankChoice>& choices) {
  const RankChoice* best = nullptr;
  for (const auto& choice : choices)
    if (choice.efficiency >= least_efficiency && (!best || choice.seconds < best->seconds))
      best = &choice;
  return best;
}

double core_hours(const RankChoice& choice) { return choice.cost.ranks * choice.seconds / 3600.0; }

nlohmann::json ranks_json(const std::vector<RankChoice>& choices) {
  nlohmann::json all = nlohmann::json::array();
  for (const auto& choice : choices)
    all.push_back({{"ranks", choice.cost.ranks},
                   {"columns", choice.cost.columns},
                   {"slabs", choice.cost.slabs},
                   {"particles_per_rank", choice.cost.particles},
                   {"ghosts_per_particle", choice.cost.ghosts},
                   {"campaign_seconds", choice.seconds},
                   {"efficiency", choice.efficiency},
                   {"memory_bytes", choice.cost.memory},
                   {"core_hours", core_hours(choice)}});
  const RankChoice* const best = recommended(choices);
  return {{"ranks", all},
          {"recommended", best ? nlohmann::json(best->cost.ranks) : nlohmann::json()}};
}

void print_ranks(const std::vector<RankChoice>& choices) {
  fmt::print(
      "Ranks (a model within a factor of three, docs/cluster.md)\n"
      "  ranks  columns x slabs  particles a rank  ghosts a particle  campaign  efficiency  "
      "memory  core hours\n");
  for (const auto& choice : choices)
    fmt::print("  {:>5}  {:>15}  {:>16.0f}  {:>17.2f}  {:>8}  {:>9.0f}%  {:>3.1f} GB  {:>10.1f}\n",
               choice.cost.ranks, fmt::format("{} x {}", choice.cost.columns, choice.cost.slabs),
               choice.cost.particles, choice.cost.ghosts, spoken_time(choice.seconds),
               100.0 * choice.efficiency, choice.cost.memory / (1 << 30), core_hours(choice));
  if (const RankChoice* const best = recommended(choices))
    fmt::print("  recommended: {} ranks, the fastest with an efficiency of {:.0f} % or more\n",
               best->cost.ranks, 100.0 * least_efficiency);
}

}  // namespace

void add_options(CLI::App& verb, CheckOptions& options) {
  add_options(verb, options.common);
  verb.add_option("--picture", options.picture,
                  "Draw the liner in its mill to scale, into this folder (as `draw` does)");
  verb.add_option("--ranks", options.ranks,
                  "Compare numbers of ranks (commas between them): time of a campaign, efficiency, "
                  "memory, core hours")
      ->delimiter(',')
      ->check(CLI::Range(1, 100000));
}

void check_verb(const CheckOptions& options) {
  const Case mill = read_case(options.common.case_file, read_drawn_liner);
  check_liner_can_be_meshed(mill);
  if (options.picture) {
    check_output_folder("--picture", *options.picture);
    publish_drawings(mill, *options.picture);
  }
  if (mill.dem.charge_from) static_cast<void>(charge_source(mill, folder_of_charge(mill)));
  const int ranks = ranks_for(mill);
  const auto choices = rank_choices(mill, options.ranks);
  if (options.common.form == OutputForm::json) {
    auto json = check_json(mill, ranks);
    if (!choices.empty()) json["rank_choices"] = ranks_json(choices);
    fmt::print("{}\n", json.dump(1));
    return;
  }
  print_check(mill, ranks);
  if (!choices.empty()) print_ranks(choices);
}

}  // namespace millwear::orchestrator
