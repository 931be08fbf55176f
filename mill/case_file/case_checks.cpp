#include "mill/case_file/case_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "mill/base/constants.h"
#include "mill/case/time_step.h"
#include "mill/liner/profile_crossing.h"
#include "mill/liner/profile_measures.h"
#include "mill/load/steady_mixing.h"

namespace millwear {
namespace {

std::string_view profile_key(const CaseDocument& document) {
  for (const std::string_view key : {"nodes_m", "profile_csv"}) {
    if (document.find("lifter")->find(key) != nullptr) {
      return key;
    }
  }
  return "height_m";
}

void check_profile(const Case& mill, const CaseDocument& document, CaseProblems& problems) {
  const LinerProfile& liner = mill.liner;
  const int line = document.line_of("lifter", profile_key(document));
  if (liner.nodes.size() > most_profile_nodes) {
    problems.add(line, fmt::format("the profile has too many nodes ({}, {} at most); thin it out",
                                   liner.nodes.size(), most_profile_nodes));
    return;
  }
  const double slack = same_point / liner.sector.plate_radius;
  for (std::size_t i = 0; i < liner.nodes.size(); ++i) {
    const Eigen::Vector2d& node = liner.nodes[i];
    const double radius = radius_of(liner.sector, node);
    if (radius >= liner.sector.shell_radius) {
      problems.add(line, fmt::format("the profile cuts into the shell (node {} at ({:.4f}, {:.4f}) "
                                     "m has radius {:.4f} m, the shell {:.4f} m); mend the node or "
                                     "`plate_thickness_m`",
                                     i, node.x(), node.y(), radius, liner.sector.shell_radius));
      return;
    }
    if (std::abs(angle_of(liner.sector, node)) > 0.5 * liner.sector.pitch() + slack) {
      problems.add(line, fmt::format("the profile leaves its sector (node {} at ({:.4f}, {:.4f}) m "
                                     "is {:.3f} degrees from the lifter's centre, half a pitch is "
                                     "{:.3f}); lower `rows` or mend the node",
                                     i, node.x(), node.y(),
                                     angle_of(liner.sector, node) * degrees_per_radian,
                                     0.5 * liner.sector.pitch() * degrees_per_radian));
      return;
    }
  }
  const auto [first, second] = first_crossing(liner);
  if (first < 0) return;
  if (const auto twice = node_given_twice(liner, {first, second})) {
    const Eigen::Vector2d& node = liner.nodes[static_cast<std::size_t>(twice->first)];
    problems.add(line, fmt::format("the profile has a node twice (its nodes {} and {} are both "
                                   "({:.6f}, {:.6f}) m, to a micrometre); delete one of the two",
                                   twice->first, twice->second, node.x(), node.y()));
  } else {
    const Eigen::Vector2d& a = liner.nodes[static_cast<std::size_t>(first)];
    const Eigen::Vector2d& b = liner.nodes[static_cast<std::size_t>(second)];
    problems.add(line, fmt::format("the profile crosses itself (segment {} from ({:.4f}, {:.4f}) m "
                                   "meets segment {} from ({:.4f}, {:.4f}) m); list its nodes in "
                                   "order along the surface",
                                   first, a.x(), a.y(), second, b.x(), b.y()));
  }
}

void check_charge_fits(const Case& mill, const CaseDocument& document, CaseProblems& problems) {
  const double largest = largest_diameter(mill);
  if (mill.slice_length < least_slice_diameters * largest) {
    problems.add(document.line_of("mill", "slice_length_m"),
                 fmt::format("the slice is too narrow for its particles ({:.4g} m, the largest is "
                             "{:.4g} m); make it {:.4g} m or more, better {:.4g} m",
                             mill.slice_length, largest, least_slice_diameters * largest,
                             advised_slice_diameters * largest));
  }
  const double open_radius = mill.liner.sector.plate_radius - lifter_height(mill.liner);
  if (largest > open_radius) {
    problems.add(document.line_of("charge", ""),
                 fmt::format("particles are too wide for the mill (the largest is {:.4g} m, from "
                             "the lifters to the axis are {:.4g} m); leave them out",
                             largest, open_radius));
  }
  const ChargeTotals charge = totals(mill);
  if (charge.particles > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    problems.add(
        document.line_of("charge", "truncate_below_m"),
        fmt::format("too many particles ({:.3g}, {} at most); raise `truncate_below_m`",
                    static_cast<double>(charge.particles), std::numeric_limits<int>::max()));
  }
  const double filling = computed_filling(mill);
  const double solid = charge.solid_volume / inside_volume(mill);
  if (filling > most_filling || solid > random_packing) {
    problems.add(document.line_of("charge", "total_filling"),
                 fmt::format("the charge does not fit (filling {:.3g}, solid share of the inside "
                             "volume {:.3g}; at most {} and {}); lower the counts or the filling",
                             filling, solid, most_filling, random_packing));
  }
}

void check_materials(const Case& mill, const CaseDocument& document, CaseProblems& problems) {
  std::set<std::size_t> charge_materials;
  for (const ParticleClass& c : mill.charge.classes) {
    charge_materials.insert(c.material);
  }
  for (auto a = charge_materials.begin(); a != charge_materials.end(); ++a) {
    for (auto b = a; b != charge_materials.end(); ++b) {
      problems.attempt(document.line_of("pairs", "materials"),
                       [&] { static_cast<void>(pair_of(mill, *a, *b)); });
    }
    if (!charge_materials.contains(mill.liner_material)) {
      problems.attempt(document.line_of("pairs", "materials"),
                       [&] { static_cast<void>(pair_of(mill, *a, mill.liner_material)); });
    }
  }
  const auto tables = document.all("materials");
  for (std::size_t i = 0; i < mill.materials.size(); ++i) {
    const Material& material = mill.materials[i];
    if (i != mill.liner_material && !charge_materials.contains(i)) {
      problems.add(tables[i]->line,
                   fmt::format("material `{}` is in neither liner nor charge; delete it and its "
                               "pairs, or use it",
                               material.name));
    }
    const double young = 2.0 * softened_shear_modulus(mill, i) * (1.0 + material.poisson_ratio);
    if (young < least_young_modulus) {
      problems.add(
          material.modulus_reduction ? tables[i]->line
                                     : document.line_of("dem", "modulus_reduction"),
          fmt::format("material `{}` is too soft for LIGGGHTS (Young's modulus {:.3g} Pa "
                      "after `modulus_reduction` = {:.4g}, {:.3g} Pa at least); lower "
                      "`modulus_reduction` to {:.3g} or less",
                      material.name, young, modulus_reduction(mill, i), least_young_modulus,
                      modulus_reduction(mill, i) * young / least_young_modulus));
    }
  }
}

void check_time_step(const Case& mill, const CaseDocument& document, CaseProblems& problems) {
  const double rayleigh = shortest_rayleigh_time(mill);
  if (mill.dem.time_step && *mill.dem.time_step > stable_rayleigh_share * rayleigh) {
    problems.add(
        document.line_of("dem", "time_step_s"),
        fmt::format("the time step is unstable ({:.3g} s, {} of the least Rayleigh time "
                    "are {:.3g} s); lower it, or raise `modulus_reduction`",
                    *mill.dem.time_step, stable_rayleigh_share, stable_rayleigh_share * rayleigh));
  }
}

void check_error_target(const Case& mill, const CaseDocument& document, CaseProblems& problems) {
  const auto& dem = mill.dem;
  if (!dem.error_target) {
    if (document.find("dem") != nullptr &&
        document.find("dem")->find("most_revolutions") != nullptr)
      problems.add(
          document.line_of("dem", "most_revolutions"),
          "`most_revolutions` says nothing without `target_relative_error`; give that too, "
          "or set `measure_revolutions` alone");
    return;
  }
  if (dem.error_target->most_revolutions < dem.measure_revolutions)
    problems.add(document.line_of("dem", "most_revolutions"),
                 fmt::format("`most_revolutions` = {:g} is less than `measure_revolutions` = {:g}, "
                             "the least number; raise it, or lower that",
                             dem.error_target->most_revolutions, dem.measure_revolutions));
  const int line = document.line_of("dem", "target_relative_error");
  if (dem.contact_path != ContactPath::recorder)
    problems.add(line,
                 "only the recorder can tell while it measures how well a rate is known; set "
                 "`wall_contacts = \"recorder\"`, or take `target_relative_error` out");
  if (mill.wear.time_blocks < least_blocks_for_a_target)
    problems.add(line,
                 fmt::format("`target_relative_error` needs an error that can be trusted, and "
                             "{} time blocks are too few for one; set `time_blocks` in [wear] "
                             "to {} or more, better 10",
                             mill.wear.time_blocks, least_blocks_for_a_target));
}

void check_life_error(const Case& mill, const CaseDocument& document, CaseProblems& problems) {
  if (mill.campaign.target_life_error && mill.dem.error_target)
    problems.add(document.line_of("campaign", "target_life_error"),
                 "`target_life_error` and `target_relative_error` in [dem] both say how long to "
                 "measure; give one of the two");
}

void check_tuning(const Case& mill, const CaseDocument& document, CaseProblems& problems) {
  if (!mill.dem.tune) return;
  if (mill.dem.skin)
    problems.add(document.line_of("dem", "skin_m"),
                 fmt::format("`skin_m` = {:g} stands beside `tune = true`, which chooses the skin "
                             "by a trial; give one of the two",
                             *mill.dem.skin));
  if (mill.dem.rank_split)
    problems.add(document.line_of("dem", "rank_split"),
                 fmt::format("`rank_split = \"{}\"` stands beside `tune = true`, which chooses the "
                             "split by a trial; give one of the two",
                             name_of(*mill.dem.rank_split)));
}

void check_rank_split(const Case& mill, const CaseDocument& document, CaseProblems& problems) {
  if (mill.dem.rank_split != RankSplit::balanced || mill.dem.contact_path == ContactPath::recorder)
    return;
  problems.add(document.line_of("dem", "rank_split"),
               "`rank_split = \"balanced\"` needs `wall_contacts = \"recorder\"`: the plain "
               "liggghts cannot move the cuts; take `charge` or `axis`");
}

void check_mixing(const Case& mill, const CaseDocument& document, CaseProblems& problems) {
  if (!mill.dem.mix_until_steady) return;
  const int line = document.line_of("dem", "mix_until_steady");
  if (mill.dem.contact_path != ContactPath::recorder)
    problems.add(line,
                 "only the recorder can tell while it mixes whether the charge is steady; set "
                 "`wall_contacts = \"recorder\"`, or take `mix_until_steady` out");
  const MixingPlan plan = mixing_plan(mill, plan_steps(mill));
  if (plan.most < least_steps(plan))
    problems.add(
        line,
        fmt::format("`mix_until_steady` can tell nothing before {:.3g} revolutions and "
                    "`mix_revolutions` = {:g} ends before; raise it, or set "
                    "`mix_until_steady = false`",
                    static_cast<double>(least_steps(plan)) / static_cast<double>(plan.revolution),
                    mill.dem.mix_revolutions));
}

void check_mechanisms(const Case& mill, const CaseDocument& document, CaseProblems& problems) {
  const auto tables = document.all("wear.mechanisms");
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const WearMechanism& mechanism = mill.wear.mechanisms[i];
    const auto& classes = mill.charge.classes;
    if (mechanism.law != WearLaw::corrosion &&
        std::none_of(classes.begin(), classes.end(),
                     [&](const ParticleClass& kind) { return concerns(mechanism, kind); })) {
      problems.add(tables[i]->line,
                   fmt::format("the mechanism concerns no particle of the charge (which has {}); "
                               "mend its `material`, `smallest_diameter_m` or "
                               "`largest_diameter_m`, or delete it",
                               spoken_classes(mill)));
    }
  }
}

void check_limits(const Case& mill, const CaseDocument& document, CaseProblems& problems) {
  const double height = lifter_height(mill.liner);
  if (mill.campaign.height_limit >= height) {
    problems.add(document.line_of("campaign", "height_limit_m"),
                 fmt::format("the liner is worn out as new (lifter {:.4g} m high, limit {:.4g} m); "
                             "lower `height_limit_m`",
                             height, mill.campaign.height_limit));
  }
  const double thickness = plate_thickness(mill.liner);
  if (mill.campaign.plate_limit >= thickness) {
    problems.add(document.line_of("campaign", "plate_limit_m"),
                 fmt::format("the plate is worn out as new ({:.4g} m thick, limit {:.4g} m); lower "
                             "`plate_limit_m`",
                             thickness, mill.campaign.plate_limit));
  }
}

}  // namespace

void check_case(const Case& mill, const CaseDocument& document, CaseProblems& problems) {
  check_profile(mill, document, problems);
  if (problems.empty()) {
    check_charge_fits(mill, document, problems);
    check_limits(mill, document, problems);
  }
  check_materials(mill, document, problems);
  check_mechanisms(mill, document, problems);
  check_time_step(mill, document, problems);
  check_error_target(mill, document, problems);
  check_life_error(mill, document, problems);
  check_tuning(mill, document, problems);
  check_rank_split(mill, document, problems);
  check_mixing(mill, document, problems);
}

}  // namespace millwear
