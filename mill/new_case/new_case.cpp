#include "mill/new_case/new_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mill/base/failure.h"
#include "mill/base/number_text.h"
#include "mill/base/text_file.h"

namespace millwear {
namespace {

constexpr double mm = 1e-3;
constexpr double whole = 100.0;  // percent
/// As the 8 m mill of 2006 (docs/seed_mill.md).
constexpr std::string_view steel_material = R"(
[[materials]]
name = "steel"
density_kg_per_m3 = 7800.0   # assumed: carbon steel
shear_modulus_pa = 7.752e10  # assumed: steel of the SAG mill of 2006
poisson_ratio = 0.29         # assumed: the same
)";
constexpr std::string_view ore_material = R"(
[[materials]]
name = "ore"
density_kg_per_m3 = 2700.0  # assumed: quartzite; give your ore's
shear_modulus_pa = 7.55e9   # assumed: ore of the SAG mill of 2006
poisson_ratio = 0.2         # assumed: the same
)";
constexpr std::string_view steel_pair = R"(
[[pairs]]
materials = ["steel", "steel"]
sliding_friction = 0.3    # assumed: the SAG mill of 2006, Table 2, like all pairs
rolling_friction = 0.001  # assumed
restitution = 0.3         # assumed
)";
constexpr std::string_view ore_pairs = R"(
[[pairs]]
materials = ["steel", "ore"]
sliding_friction = 0.5    # assumed
rolling_friction = 0.002  # assumed
restitution = 0.5         # assumed

[[pairs]]
materials = ["ore", "ore"]
sliding_friction = 0.8    # assumed
rolling_friction = 0.005  # assumed
restitution = 0.5         # assumed
)";

[[noreturn]] void refuse_shares(std::string_view text, std::string_view what) {
  throw InputError(
      fmt::format("{} {}; write sizes like \"90:39.9,63:60.1\": mm, and what is "
                  "retained in percent",
                  in_quotes(text), what));
}

double positive_number(std::string_view text, std::string_view all) {
  const auto value = number_of(text);
  if (!value || !(*value > 0.0))
    refuse_shares(all, fmt::format("has {} where a number above 0 belongs", in_quotes(text)));
  return *value;
}

double assumed_height(const NewCase& wanted) { return 0.05 * 0.5 * wanted.shell_diameter; }

double largest_of(const NewCase& wanted) {
  double largest = 0.0;
  for (const auto* const sizes : {&wanted.balls, &wanted.ore})
    for (const SizeShare& size : *sizes) largest = std::max(largest, size.diameter);
  return largest;
}

std::string mill_text(const NewCase& wanted) {
  constexpr double diameters_a_slice = 4.0;
  const double slice = std::ceil(100.0 * diameters_a_slice * largest_of(wanted)) / 100.0;
  std::string speed = "critical_speed_fraction = 0.75  # assumed; or give speed_rpm";
  if (wanted.speed_rpm) speed = fmt::format("speed_rpm = {}  # given", *wanted.speed_rpm);
  if (wanted.critical_fraction)
    speed = fmt::format("critical_speed_fraction = {}  # given", *wanted.critical_fraction);
  return fmt::format(
      "\n[mill]\nshell_diameter_m = {}  # given: inside the shell, under the liner\n"
      "slice_length_m = {}  # derived: {:.0f} diameters of the largest particle\nrows = {}  # "
      "given\n{}\n",
      wanted.shell_diameter, slice, diameters_a_slice, wanted.rows, speed);
}

/// A length [m] that was given, or the assumption in its place.
std::string length_line(std::string_view key, std::optional<double> given, double assumed,
                        std::string_view why) {
  if (given) return fmt::format("{} = {}  # given\n", key, *given);
  return fmt::format("{} = {:.3g}  # assumed: {}\n", key, assumed, why);
}

std::string liner_text(const NewCase& wanted) {
  const NewLiner& liner = wanted.liner;
  const double radius = 0.5 * wanted.shell_diameter;
  std::string text = "\n[lifter]\nmaterial = \"steel\"  # assumed\n";
  text += length_line("plate_thickness_m", liner.plate_thickness,
                      assumed_plate(wanted.shell_diameter), "a fiftieth of the radius; measure it");
  if (liner.drawing) {
    text += fmt::format("profile_dxf = \"{}\"  # given\n", *liner.drawing);
    if (liner.unit)
      text += fmt::format("profile_unit = \"{}\"  # given\n", name_of(*liner.unit).symbol);
    return text;
  }
  text +=
      length_line("height_m", liner.height, assumed_height(wanted), "a twentieth of the radius");
  text +=
      length_line("top_width_m", liner.top_width, 0.03 * radius, "three fifths of such a height");
  for (const char* const key : {"leading_face_angle_deg", "trailing_face_angle_deg"})
    text += liner.face_angle ? fmt::format("{} = {}  # given\n", key, *liner.face_angle)
                             : fmt::format("{} = 15.0  # assumed\n", key);
  return text;
}

std::string distribution_text(std::string_view material, const std::vector<SizeShare>& sizes) {
  if (sizes.empty()) return {};
  std::vector<double> diameters;
  std::vector<double> percents;
  for (const SizeShare& size : sizes) {
    diameters.push_back(size.diameter);
    percents.push_back(size.percent);
  }
  return fmt::format(
      "\n[[charge.distributions]]\nmaterial = \"{}\"\nsize_m = [{}]  # given\n"
      "retained_percent = [{}]  # given\n",
      material, fmt::join(diameters, ", "), fmt::join(percents, ", "));
}

std::string charge_text(const NewCase& wanted) {
  std::string text = fmt::format(
      "\n[charge]\nporosity = 0.4  # assumed: loose spheres at rest\n"
      "total_filling = {}  # given\n",
      wanted.filling);
  if (!wanted.balls.empty() && !wanted.ore.empty())
    text += fmt::format(
        "ball_filling = {}  # given\nball_material = \"steel\"\nore_material = \"ore\"\n",
        *wanted.ball_filling);
  return text + distribution_text("steel", wanted.balls) + distribution_text("ore", wanted.ore);
}

std::string settings_text(const NewCase& wanted) {
  const double tall = wanted.liner.height.value_or(assumed_height(wanted));
  return "\n[dem]\nmodulus_reduction = 100.0   # assumed: softer contacts, for a longer time step\n"
         "mix_revolutions = 2.0       # assumed; a charge of many sizes sorts for four\n"
         "settle_pitches = 2          # assumed\nmeasure_revolutions = 0.25  # assumed; more gives "
         "narrower bands\ntune = true                 # finds the fastest neighbour skin by a "
         "trial\n"
         "\n[wear]\nlaw = \"archard\"  # assumed\nspecific_wear_rate_per_pa = 5e-12  # assumed: "
         "hours are "
         "proportional to 1 / this; calibrate it on a gauge reading\n\n[campaign]\nscheme = "
         "\"adaptive\"  # loads are simulated where the accuracy asks for them\n" +
         fmt::format(
             "height_limit_m = {:.3g}  # assumed: a fifth of the height; when do you reline?\n",
             0.2 * tall) +
         "cycle_limit = 60     # assumed: more than it takes\n";
}

void check(const NewCase& wanted) {
  if (wanted.balls.empty() && wanted.ore.empty())
    throw InputError("the charge is not given; name its sizes with --balls, --ore or both");
  if (!wanted.balls.empty() && !wanted.ore.empty() && !wanted.ball_filling)
    throw InputError(
        "balls and ore share the filling; say how much of the mill the balls fill with "
        "--ball-filling");
}

}  // namespace

double assumed_plate(double shell_diameter) { return 0.02 * 0.5 * shell_diameter; }

std::vector<SizeShare> size_shares(std::string_view text) {
  std::vector<SizeShare> sizes;
  for (std::string_view left = text; !left.empty() || sizes.empty();) {
    const std::size_t comma = std::min(left.find(','), left.size());
    const std::string_view one = left.substr(0, comma);
    const std::size_t colon = one.find(':');
    const double diameter = mm * positive_number(one.substr(0, colon), text);
    const double percent =
        colon == std::string_view::npos ? whole : positive_number(one.substr(colon + 1), text);
    if (!sizes.empty() && diameter >= sizes.back().diameter)
      refuse_shares(text, "does not begin with the largest size and fall");
    sizes.push_back({diameter, percent});
    left.remove_prefix(std::min(comma + 1, left.size()));
  }
  return sizes;
}

std::string new_case_text(const NewCase& wanted) {
  check(wanted);
  const bool has_ore = !wanted.ore.empty();
  return fmt::format(
             "# Written by `millwear new`. Every line says whether it was given, derived or "
             "assumed.\n# docs/case_file.md describes all keys.\nformat_version = 1\nname = "
             "\"{}\"\n",
             wanted.name) +
         mill_text(wanted) + liner_text(wanted) + std::string(steel_material) +
         std::string(has_ore ? ore_material : "") + std::string(steel_pair) +
         std::string(has_ore ? ore_pairs : "") + charge_text(wanted) + settings_text(wanted);
}

}  // namespace millwear
