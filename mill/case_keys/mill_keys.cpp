#include "mill/case_keys/mill_keys.h"

#include "mill/base/length_unit.h"
#include "mill/case/case_units.h"

namespace millwear {
namespace {

using key::converted;
using key::in;
using key::left_to_builder;
using key::optional;
using key::required;

key::Place<Case, int> format_version() {
  return {[](Case&, int) {}, [](const Case&) { return case_format_version; }};
}

key::Place<Case, double> shell_diameter() {
  return {[](Case& mill, double diameter) { mill.liner.sector.shell_radius = 0.5 * diameter; },
          [](const Case& mill) { return 2.0 * mill.liner.sector.shell_radius; }};
}

key::Place<Case, int> rows_around() {
  return {[](Case& mill, int rows) { mill.liner.sector.rows = rows; },
          [](const Case& mill) { return mill.liner.sector.rows; }};
}

key::Place<Case, double> plate_thickness_of_new() {
  return {[](Case& mill, double thickness) {
            mill.liner.sector.plate_radius = mill.liner.sector.shell_radius - thickness;
          },
          [](const Case& mill) {
            return mill.liner.sector.shell_radius - mill.liner.sector.plate_radius;
          }};
}

KeyRow<LinerProfile> drawing_unit() {
  std::string symbols;
  for (const LengthUnitName& name : length_units())
    symbols += (symbols.empty() ? "" : "|") + std::string(name.symbol);
  return {.spec = {"", "profile_unit", KeyType::choice, Presence::optional, any_value,
                   "unit of the drawing, in place of its own", "", symbols}};
}

}  // namespace

const std::vector<KeyRow<Case>>& top_keys() {
  static const auto rows =
      rows_of<Case>("", {required("format_version", format_version(),
                                  between(1, case_format_version), "version of this format: 1"),
                         required("name", in(&Case::name), any_value,
                                  "the mill's name: 1 to 64 of A-Z a-z 0-9 _ -")});
  return rows;
}

const std::vector<KeyRow<Case>>& mill_keys() {
  static const auto rows = rows_of<Case>(
      "mill",
      {required("shell_diameter_m", shell_diameter(), above_up_to(0.0, 50.0),
                "inside diameter of the shell, under the liner [m]"),
       required("slice_length_m", in(&Case::slice_length), above_up_to(0.0, 50.0),
                "length of the simulated slice along the axis, periodic [m]"),
       required("rows", rows_around(), between(4, 1000), "lifters around the mill"),
       optional("speed_rpm", converted(speed_from_rpm, in(&Case::speed)), positive,
                "speed [1/min]; this or `critical_speed_fraction`"),
       left_to_builder<Case>(
           Presence::optional, KeyType::real, "critical_speed_fraction", above_up_to(0.0, 3.0),
           "speed as a share of the one at which the largest particle centrifuges on the plate "
           "[-]"),
       optional("feed_rate_t_per_h", converted(feed_from_t_per_h, in(&Case::feed_rate)), positive,
                "fresh feed, to report wear per tonne [t/h]")});
  return rows;
}

const std::vector<KeyRow<Case>>& lifter_keys() {
  static const auto rows =
      rows_of<Case>("lifter", {left_to_builder<Case>(Presence::required, KeyType::name, "material",
                                                     any_value, "the liner's material"),
                               required("plate_thickness_m", plate_thickness_of_new(), positive,
                                        "thickness of the new plate between lifters [m]")});
  return rows;
}

const std::vector<KeyRow<ParametricLifter>>& lifter_shape_keys() {
  using Shape = ParametricLifter;
  static const auto rows = rows_of<Shape>(
      "lifter",
      {optional("height_m", in(&Shape::height), positive,
                "height of the lifter over the plate at its centre [m]"),
       optional("top_width_m", in(&Shape::top_width), positive, "width of the lifter's top [m]"),
       optional("leading_face_angle_deg",
                converted(angle_from_degrees, in(&Shape::leading_face_angle)), between(0.0, 80.0),
                "leading face against the radial direction, 0 upright [degrees]"),
       optional("trailing_face_angle_deg",
                converted(angle_from_degrees, in(&Shape::trailing_face_angle)), between(0.0, 80.0),
                "trailing face against the radial direction, 0 upright [degrees]")});
  return rows;
}

const std::vector<KeyRow<ParametricLifter>>& lifter_radius_keys() {
  using Shape = ParametricLifter;
  static const auto rows =
      rows_of<Shape>("lifter", {optional("top_radius_m", in(&Shape::top_radius), positive,
                                         "radius between the lifter's top and its faces [m]"),
                                optional("foot_radius_m", in(&Shape::foot_radius), positive,
                                         "radius between its faces and the plate [m]")});
  return rows;
}

const std::vector<KeyRow<LinerProfile>>& lifter_profile_keys() {
  using Profile = LinerProfile;
  static const auto rows = rows_of<Profile>(
      "lifter",
      {left_to_builder<Profile>(
           Presence::defaulted, KeyType::boolean, "straight_plate", any_value,
           "plate between lifters as a straight line, as the 2006 paper drew it, in place of the "
           "arc",
           "false"),
       left_to_builder<Profile>(
           Presence::optional, KeyType::file, "profile_csv", any_value,
           "measured profile, columns `xi_m,eta_m`; path from this file's folder"),
       left_to_builder<Profile>(Presence::optional, KeyType::file, "profile_dxf", any_value,
                                "drawing of the new liner (DXF); path from this file's folder "
                                "(how_to_describe_a_mill.md)"),
       left_to_builder<Profile>(Presence::optional, KeyType::words, "profile_layer", any_value,
                                "layer of the drawing that the profile is on"),
       drawing_unit(),
       left_to_builder<Profile>(
           Presence::optional, KeyType::reals, "profile_origin", any_value,
           "x and y, in the drawing's unit, of the place on the new plate at the lifter's centre, "
           "with "
           "y towards the mill's axis; without it the ends of the curve lie on the plate"),
       left_to_builder<Profile>(Presence::defaulted, KeyType::boolean, "profile_mirrored",
                                any_value, "the drawing's x runs against the direction of rotation",
                                "false"),
       left_to_builder<Profile>(
           Presence::optional, KeyType::points, "nodes_m", between(-50.0, 50.0),
           "the profile's nodes [[xi, eta], ...] from the trailing side to the leading one [m]")});
  return rows;
}

}  // namespace millwear
