#include "mill/case_file/case_build_liner.h"

#include <fmt/format.h>

#include "mill/case_file/case_values.h"
#include "mill/case_keys/mill_keys.h"
#include "mill/liner/parametric_lifter.h"
#include "mill/liner/profile_csv.h"
#include "mill/liner/profile_ends.h"

namespace millwear {
namespace {

LinerProfile build_parametric(const CaseTable& lifter, const LinerSector& sector) {
  ParametricLifter shape{};
  read_keys(lifter_shape_keys(), &lifter, shape);
  return profile_of(
      sector, shape,
      boolean_value(lifter, "straight_plate") ? PlateShape::straight : PlateShape::arc);
}

/// Exactly one of the three forms of a lifter, with every key of the parametric one.
void check_form(const CaseTable& lifter, CaseProblems& problems) {
  const bool csv = lifter.find("profile_csv") != nullptr;
  const bool nodes = lifter.find("nodes_m") != nullptr;
  std::string missing;
  std::string present;
  for (const KeyRow<ParametricLifter>& row : lifter_shape_keys()) {
    std::string& list = lifter.find(row.spec.key) == nullptr ? missing : present;
    list += fmt::format("{}`{}`", list.empty() ? "" : ", ", row.spec.key);
  }
  if (csv && nodes) {
    problems.add(lifter.line, "[lifter] has both `profile_csv` and `nodes_m`; give one of the two");
  } else if ((csv || nodes) && !present.empty()) {
    problems.add(lifter.line,
                 fmt::format("[lifter] has a measured profile and a parametric shape ({}); give "
                             "one of the two",
                             present));
  } else if ((csv || nodes) && lifter.find("straight_plate") != nullptr) {
    problems.add(lifter.find("straight_plate")->line,
                 "`straight_plate` goes with a parametric lifter only (the plate of a measured "
                 "profile is as measured); delete it");
  } else if (!csv && !nodes && !missing.empty()) {
    problems.add(lifter.line,
                 fmt::format("[lifter] has no {} (a parametric lifter takes all four); add them, "
                             "or give `profile_csv` or `nodes_m`",
                             missing));
  }
}

}  // namespace

LinerProfile build_liner(const CaseDocument& document, const LinerSector& sector,
                         CaseProblems& problems) {
  const CaseTable& lifter = *document.find("lifter");
  const double thickness = real_value(lifter, "plate_thickness_m");
  LinerProfile liner{sector, {}};
  check_form(lifter, problems);
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
  } else if (const CaseValue* const nodes = lifter.find("nodes_m")) {
    problems.attempt(nodes->line, [&] {
      liner = completed_profile(liner.sector, point_values(lifter, "nodes_m"));
    });
  } else {
    problems.attempt(lifter.line, [&] { liner = build_parametric(lifter, liner.sector); });
  }
  return liner;
}

}  // namespace millwear
