#include "orchestrator/drawing/drawn_liner_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "meshgen/drawing/drawing_profile.h"
#include "mill/base/failure.h"
#include "mill/liner/parametric_lifter.h"
#include "mill/liner/profile_ends.h"
#include "wear/gauge/point_order.h"
#include "wear/gauge/profile_alignment.h"

namespace millwear::orchestrator {
namespace {

using wear::Curve;

/// How well a drawing says a length [m].
constexpr double drawing_error = 1e-5;

/// The curve [m], its x along the direction of rotation.
Curve curve_of(const DrawnLiner& drawn) {
  const auto profile = meshgen::drawing_profile(drawn.file, drawn.layer);
  const auto unit = drawn.unit ? drawn.unit : profile.unit;
  if (!unit) throw InputError("the drawing does not say its unit; give `profile_unit`");
  Curve curve;
  for (const Eigen::Vector2d& node : profile.nodes)
    curve.emplace_back(name_of(*unit).metres *
                       (node - drawn.origin.value_or(Eigen::Vector2d::Zero())));
  return drawn.is_mirrored ? wear::mirror_image(curve) : curve;
}

void check_size(const Curve& curve, const LinerSector& sector) {
  const double pitch = sector.pitch() * sector.plate_radius;
  const double chord = (curve.back() - curve.front()).norm();
  if (chord > 0.05 * pitch && chord < 1.05 * pitch) return;
  throw InputError(fmt::format(
      "the curve's ends are {:.4g} m apart, and a pitch of the plate is {:.4g} m; draw one lifter "
      "from plate to plate, or say the drawing's unit with `profile_unit`",
      chord, pitch));
}

/// A slim lifter as high as the curve rises over the line between its ends, to tell up from down.
LinerProfile upright_lifter(const Curve& curve, const LinerSector& sector) {
  const Eigen::Vector2d chord = curve.back() - curve.front();
  double height = 0.0;
  for (const Eigen::Vector2d& node : curve) {
    const Eigen::Vector2d from = node - curve.front();
    height = std::max(height, std::abs(chord.x() * from.y() - chord.y() * from.x()) / chord.norm());
  }
  const double highest = 0.5 * sector.plate_radius;
  return profile_of(sector, {std::min(height, highest), 0.05 * chord.norm(), 0.0, 0.0});
}

Curve placed(const Curve& curve, const DrawnLiner& drawn, const LinerSector& sector) {
  if (drawn.origin) return wear::kept_in_place(sector, curve).nodes;
  return wear::aligned_by_ends(upright_lifter(curve, sector), curve, sector.plate_radius,
                               drawing_error)
      .nodes;
}

}  // namespace

LinerProfile read_drawn_liner(const DrawnLiner& drawn, const LinerSector& sector) {
  const std::string name = drawn.file.string() + ": ";
  try {
    const Curve curve = curve_of(drawn);
    check_size(curve, sector);
    return completed_profile(sector, placed(curve, drawn, sector));
  } catch (const InputError& problem) {
    const std::string what = problem.what();
    const bool is_named = what.starts_with(drawn.file.string() + ":");
    throw InputError(is_named ? what : name + what);
  }
}

std::vector<std::string> left_out_of(const DrawnLiner& drawn) {
  return meshgen::drawing_profile(drawn.file, drawn.layer).left_out;
}

}  // namespace millwear::orchestrator
