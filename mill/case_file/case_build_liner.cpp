#include "mill/case_file/case_build_liner.h"

#include <fmt/format.h>

#include <array>
#include <span>
#include <string_view>

#include "mill/case_file/case_values.h"
#include "mill/case_keys/mill_keys.h"
#include "mill/liner/parametric_lifter.h"
#include "mill/liner/profile_crossing.h"
#include "mill/liner/profile_csv.h"
#include "mill/liner/profile_ends.h"

namespace millwear {
namespace {

LinerProfile build_parametric(const CaseTable& lifter, const LinerSector& sector) {
  ParametricLifter shape{};
  read_keys(lifter_shape_keys(), &lifter, shape);
  read_keys(lifter_radius_keys(), &lifter, shape);
  return profile_of(
      sector, shape,
      boolean_value(lifter, "straight_plate") ? PlateShape::straight : PlateShape::arc);
}

/// The keys of [lifter] that give a whole profile.
constexpr std::array<std::string_view, 3> profile_keys = {"profile_csv", "profile_dxf", "nodes_m"};
/// Those that say how a drawing is read.
constexpr std::array<std::string_view, 4> drawing_keys = {"profile_layer", "profile_unit",
                                                          "profile_origin", "profile_mirrored"};

std::vector<std::string_view> given(const CaseTable& lifter,
                                    std::span<const std::string_view> keys) {
  std::vector<std::string_view> found;
  for (const std::string_view key : keys)
    if (lifter.find(key) != nullptr) found.push_back(key);
  return found;
}

std::string in_backticks(std::span<const std::string_view> keys) {
  std::string list;
  for (const std::string_view key : keys)
    list += fmt::format("{}`{}`", list.empty() ? "" : ", ", key);
  return list;
}

/// Exactly one of the forms of a lifter, with every key of the parametric one.
void check_form(const CaseTable& lifter, CaseProblems& problems) {
  const auto profiles = given(lifter, profile_keys);
  std::vector<std::string_view> missing;
  std::vector<std::string_view> present;
  for (const KeyRow<ParametricLifter>& row : lifter_shape_keys())
    (lifter.find(row.spec.key) == nullptr ? missing : present).push_back(row.spec.key);
  for (const KeyRow<ParametricLifter>& row : lifter_radius_keys())
    if (lifter.find(row.spec.key) != nullptr) present.push_back(row.spec.key);
  if (profiles.size() > 1) {
    problems.add(lifter.line,
                 fmt::format("[lifter] has {}; give one of them", in_backticks(profiles)));
  } else if (!profiles.empty() && !present.empty()) {
    problems.add(lifter.line,
                 fmt::format("[lifter] has a measured profile and a parametric shape ({}); give "
                             "one of the two",
                             in_backticks(present)));
  } else if (!profiles.empty() && lifter.find("straight_plate") != nullptr) {
    problems.add(lifter.find("straight_plate")->line,
                 "`straight_plate` goes with a parametric lifter only (the plate of a measured "
                 "profile is as measured); delete it");
  } else if (profiles.empty() && !missing.empty()) {
    problems.add(lifter.line,
                 fmt::format("[lifter] has no {} (a parametric lifter takes all four); add them, "
                             "or give `profile_csv`, `profile_dxf` or `nodes_m`",
                             in_backticks(missing)));
  }
  if (lifter.find("straight_plate") != nullptr && lifter.find("foot_radius_m") != nullptr)
    problems.add(lifter.find("foot_radius_m")->line,
                 "`foot_radius_m` goes with the plate's arc; delete it or `straight_plate`");
  if (lifter.find("profile_dxf") == nullptr)
    for (const std::string_view key : given(lifter, drawing_keys))
      problems.add(lifter.find(key)->line,
                   fmt::format("`{}` says how a drawing is read, and there is no `profile_dxf`; "
                               "delete it",
                               key));
}

void check_origin(const CaseTable& lifter, CaseProblems& problems) {
  const CaseValue* const origin = lifter.find("profile_origin");
  if (origin == nullptr || numbers_in(*origin).size() == 2) return;
  problems.add(origin->line,
               fmt::format("`profile_origin` has {} numbers; give x and y of the place on the new "
                           "plate at the lifter's centre, in the drawing's unit",
                           numbers_in(*origin).size()));
}

}  // namespace

std::optional<DrawnLiner> drawn_liner_in(const CaseDocument& document) {
  const CaseTable& lifter = *document.find("lifter");
  const auto file = optional_text(lifter, "profile_dxf");
  if (!file) return std::nullopt;
  DrawnLiner drawn{document.file.parent_path() / *file, optional_text(lifter, "profile_layer"),
                   std::nullopt, std::nullopt, boolean_value(lifter, "profile_mirrored")};
  if (const auto unit = optional_text(lifter, "profile_unit"))
    drawn.unit = length_unit_called(*unit);
  if (lifter.find("profile_origin") != nullptr) {
    const auto origin = real_values(lifter, "profile_origin");
    drawn.origin = Eigen::Vector2d(origin.at(0), origin.at(1));
  }
  return drawn;
}

LinerProfile build_liner(const CaseDocument& document, const LinerSector& sector,
                         const ReadDrawnLiner& draw, CaseProblems& problems) {
  const CaseTable& lifter = *document.find("lifter");
  const double thickness = real_value(lifter, "plate_thickness_m");
  LinerProfile liner{sector, {}};
  check_form(lifter, problems);
  check_origin(lifter, problems);
  if (thickness >= 0.5 * sector.shell_radius) {
    problems.add(lifter.find("plate_thickness_m")->line,
                 fmt::format("the plate fills the mill ({:.4g} m thick, the shell's radius is "
                             "{:.4g} m); keep it under half of that",
                             thickness, sector.shell_radius));
  }
  if (!problems.empty()) {
    return liner;
  }
  if (const CaseValue* const csv = lifter.find("profile_csv")) {
    const auto path = document.file.parent_path() / std::get<std::string>(csv->data);
    problems.attempt(csv->line, [&] { liner = read_profile_csv(path, liner.sector); });
  } else if (const auto drawn = drawn_liner_in(document)) {
    problems.attempt(lifter.find("profile_dxf")->line, [&] { liner = draw(*drawn, liner.sector); });
  } else if (const CaseValue* const nodes = lifter.find("nodes_m")) {
    const auto points = point_values(lifter, "nodes_m");
    if (const auto again = first_repeated_node(points)) {
      problems.add(std::get<CaseArray>(nodes->data)[*again].line,
                   fmt::format("`nodes_m` gives a node twice (number {} and number {}, both "
                               "({:.6g}, {:.6g}) m); delete one of the two",
                               *again, *again + 1, points[*again].x(), points[*again].y()));
      return liner;
    }
    problems.attempt(nodes->line, [&] { liner = completed_profile(liner.sector, points); });
  } else {
    problems.attempt(lifter.line, [&] { liner = build_parametric(lifter, liner.sector); });
  }
  return liner;
}

}  // namespace millwear
