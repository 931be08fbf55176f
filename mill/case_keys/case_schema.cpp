#include "mill/case_keys/case_schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace millwear {
namespace {

using enum KeyType;
using enum Presence;

constexpr KeyRange any{};
constexpr KeyRange positive{.low = 0.0, .above_low = true};
constexpr KeyRange at_least(double low) { return {.low = low}; }
constexpr KeyRange between(double low, double high) { return {.low = low, .high = high}; }
constexpr KeyRange above_up_to(double low, double high) { return {low, high, true}; }

constexpr std::string_view wear_laws =
    "archard|finnie|normal_dissipation|excess_energy|shear_dissipation|incident_energy|"
    "shear_impact_energy|corrosion";

constexpr std::array<TableSpec, 13> tables{{
    {"", false, true, "The keys before the first table."},
    {"mill", false, true, "The mill and the slice of it that is simulated."},
    {"lifter", false, true,
     "One lifter and its share of the plate: by `height_m`, `top_width_m` and two face angles, or "
     "measured in `profile_csv`, or listed in `nodes_m`."},
    {"materials", true, true, "A solid: the liner's, a ball's, an ore's."},
    {"pairs", true, true, "How two materials touch; one for each pair that can meet."},
    {"charge", false, true,
     "Balls and ore: by [[charge.counts]], or by `total_filling` and [[charge.distributions]]."},
    {"charge.counts", true, false, "Particles of one material and one size in the slice."},
    {"charge.distributions", true, false,
     "Sieve analysis of one material. Its share of the filling becomes particle counts: bulk "
     "volume = filling x pi R^2 L with R the plate's radius, solid = bulk x (1 - porosity)."},
    {"dem", false, false, "The discrete element model."},
    {"wear", false, true,
     "From wall contacts to lost steel: one law for all particles here, or a sum of laws in "
     "[[wear.mechanisms]]."},
    {"wear.mechanisms", true, false,
     "One law of the sum. Where two of the same law concern the same particles, their "
     "coefficients add."},
    {"campaign", false, true, "When the DEM is run anew, and when the liner is worn out."},
    {"gauge", false, false,
     "How the gauge readings beside this file are held against the campaign. It may be changed at "
     "any time: what is simulated does not depend on it, and `case.lock.toml` has none of it."},
}};

constexpr KeySpec keys[] = {
    {"", "format_version", integer, required, "", between(1, case_format_version), "",
     "version of this format: 1"},
    {"", "name", name, required, "", any, "", "the mill's name: 1 to 64 of A-Z a-z 0-9 _ -"},

    {"mill", "shell_diameter_m", real, required, "", above_up_to(0.0, 50.0), "",
     "inside diameter of the shell, under the liner [m]"},
    {"mill", "slice_length_m", real, required, "", above_up_to(0.0, 50.0), "",
     "length of the simulated slice along the axis, periodic [m]"},
    {"mill", "rows", integer, required, "", between(4, 1000), "", "lifters around the mill"},
    {"mill", "speed_rpm", real, optional, "", positive, "",
     "speed [1/min]; this or `critical_speed_fraction`"},
    {"mill", "critical_speed_fraction", real, optional, "", above_up_to(0.0, 3.0), "",
     "speed as a share of the one at which the largest particle centrifuges on the plate [-]"},
    {"mill", "feed_rate_t_per_h", real, optional, "", positive, "",
     "fresh feed, to report wear per tonne [t/h]"},

    {"lifter", "material", name, required, "", any, "", "the liner's material"},
    {"lifter", "plate_thickness_m", real, required, "", positive, "",
     "thickness of the new plate between lifters [m]"},
    {"lifter", "height_m", real, optional, "", positive, "",
     "height of the lifter over the plate at its centre [m]"},
    {"lifter", "top_width_m", real, optional, "", positive, "", "width of the lifter's top [m]"},
    {"lifter", "leading_face_angle_deg", real, optional, "", between(0.0, 80.0), "",
     "leading face against the radial direction, 0 upright [degrees]"},
    {"lifter", "trailing_face_angle_deg", real, optional, "", between(0.0, 80.0), "",
     "trailing face against the radial direction, 0 upright [degrees]"},
    {"lifter", "straight_plate", boolean, defaulted, "false", any, "",
     "plate between lifters as a straight line, as the 2006 paper drew it, in place of the arc"},
    {"lifter", "profile_csv", file, optional, "", any, "",
     "measured profile, columns `xi_m,eta_m`; path from this file's folder"},
    {"lifter", "nodes_m", points, optional, "", between(-50.0, 50.0), "",
     "the profile's nodes [[xi, eta], ...] from the trailing side to the leading one [m]"},

    {"materials", "name", name, required, "", any, "", "1 to 64 of A-Z a-z 0-9 _ -"},
    {"materials", "density_kg_per_m3", real, required, "", positive, "", "density [kg/m3]"},
    {"materials", "shear_modulus_pa", real, required, "", positive, "",
     "shear modulus as measured, before `modulus_reduction` [Pa]"},
    {"materials", "poisson_ratio", real, required, "", between(0.0, 0.499), "",
     "Poisson's ratio [-]"},
    {"materials", "modulus_reduction", real, optional, "", at_least(1.0), "",
     "this material's modulus is divided by this, in place of `modulus_reduction` of `[dem]` [-]"},

    {"pairs", "materials", names, required, "", any, "", "the names of the two materials"},
    {"pairs", "sliding_friction", real, required, "", between(0.0, 10.0), "",
     "coefficient of sliding friction [-]"},
    {"pairs", "rolling_friction", real, required, "", between(0.0, 10.0), "",
     "coefficient of rolling friction [-]"},
    {"pairs", "restitution", real, required, "", between(0.05, 1.0), "",
     "coefficient of restitution [-]; LIGGGHTS takes none below 0.05"},

    {"charge", "porosity", real, defaulted, "0.4", between(0.0, 0.9), "",
     "voids of the charge at rest, share of its bulk volume [-]"},
    {"charge", "truncate_below_m", real, defaulted, "0", at_least(0.0), "",
     "sizes under this are left out; a distribution keeps its volume [m]"},
    {"charge", "declared_total_filling", real, optional, "", above_up_to(0.0, 0.9), "",
     "with counts: total filling the owner declares, compared with the counts' own [-]"},
    {"charge", "declared_ball_filling", real, optional, "", above_up_to(0.0, 0.9), "",
     "with counts: ball filling the owner declares [-]"},
    {"charge", "total_filling", real, optional, "", above_up_to(0.0, 0.9), "",
     "bulk volume of the whole charge, share of the volume inside the plate [-]"},
    {"charge", "ball_filling", real, optional, "", above_up_to(0.0, 0.9), "",
     "bulk volume of the balls, part of `total_filling`; with two distributions [-]"},
    {"charge", "ball_material", name, optional, "", any, "",
     "the distribution that gets `ball_filling`"},
    {"charge", "ore_material", name, optional, "", any, "",
     "the distribution that gets the rest of `total_filling`"},

    {"charge.counts", "material", name, required, "", any, "", "material of the particles"},
    {"charge.counts", "diameter_m", real, required, "", positive, "", "diameter [m]"},
    {"charge.counts", "count", integer, required, "", between(1, 1e8), "",
     "particles in the slice"},

    {"charge.distributions", "material", name, required, "", any, "", "material of the particles"},
    {"charge.distributions", "size_m", reals, required, "", positive, "",
     "lower limit of each class, largest first, taken as the diameter [m]"},
    {"charge.distributions", "retained_percent", reals, required, "", between(0.0, 100.0), "",
     "share of the material's volume in each class; only the proportions count [%]"},

    {"dem", "modulus_reduction", real, defaulted, "100", at_least(1.0), "",
     "the shear moduli are divided by this, for a longer time step [-]"},
    {"dem", "rayleigh_fraction", real, defaulted, "0.3", above_up_to(0.0, 0.5), "",
     "time step as a share of the least Rayleigh time [-]"},
    {"dem", "longest_time_step_s", real, optional, "", positive, "",
     "the time step is never above this [s]"},
    {"dem", "time_step_s", real, optional, "", positive, "",
     "time step in place of `rayleigh_fraction`, cut so that a pitch takes whole steps [s]"},
    {"dem", "rolling_friction_model", choice, defaulted, "\"cdt\"", any, "cdt|epsd2",
     "rolling friction: constant torque, or elastic-plastic spring-dashpot"},
    {"dem", "mix_revolutions", real, defaulted, "2", at_least(0.0), "",
     "revolutions before the first measurement; with `mix_until_steady` the most"},
    {"dem", "mix_until_steady", boolean, defaulted, "false", any, "",
     "mixing ends as soon as torque and kinetic energy drift no longer (with `recorder`)"},
    {"dem", "settle_pitches", integer, defaulted, "2", between(0, 100000), "",
     "pitches turned on a new mesh before the load is measured"},
    {"dem", "measure_revolutions", real, defaulted, "1", positive, "",
     "revolutions over which the load is measured; with `target_relative_error` the least number"},
    {"dem", "target_relative_error", real, optional, "", above_up_to(0.0, 1.0), "",
     "a measurement goes on until the smoothed rate of loss at its peaks is known to this relative "
     "standard error (with `recorder`)"},
    {"dem", "most_revolutions", real, optional, "", positive, "",
     "with `target_relative_error`: a measurement ends after so many revolutions in any case; four "
     "times `measure_revolutions` where it is missing"},
    {"dem", "wall_contacts", choice, defaulted, "\"recorder\"", any, "recorder|dumps",
     "how wall contacts are seen: `recorder` takes every step from inside LIGGGHTS, `dumps` "
     "samples through the text dumps of the plain `liggghts`"},
    {"dem", "sample_every_steps", integer, optional, "", between(1, 1000000), "",
     "time steps between two samples of the wall contacts; 1 for the recorder and 20 for dumps "
     "where it is missing"},
    {"dem", "ranks", integer, defaulted, "0", between(0, 100000), "",
     "MPI ranks; 0 takes every core"},
    {"dem", "skin_m", real, optional, "", positive, "",
     "neighbour skin; the least particle's radius where it is missing [m]"},
    {"dem", "rank_split", choice, optional, "", any, "charge|axis",
     "how an even number of ranks share the mill: on either side of the moving `charge`'s middle "
     "(where it is missing), or in slabs along the `axis`, as an odd number always do"},
    {"dem", "tune", boolean, defaulted, "false", any, "",
     "`millwear run` chooses the neighbour skin and the split among ranks by a short trial on the "
     "mixed charge; in place of `skin_m` and `rank_split`"},
    {"dem", "mesh_tolerance", real, defaulted, "0.03", above_up_to(0.0, 0.5), "",
     "mesh against profile, share of the least particle radius [-]"},
    {"dem", "seed", integer, defaulted, "1", between(1, 2147483647), "",
     "seed of the first packing"},
    {"dem", "keep_dumps", boolean, defaulted, "false", any, "",
     "keep the contact dumps (with `dumps`)"},
    {"dem", "keep_events", boolean, defaulted, "false", any, "",
     "keep a row for every collision with the liner, `events.h5` (with `recorder`)"},
    {"dem", "pair_revolutions", real, defaulted, "0.02", between(0.0, 100.0), "",
     "revolutions at the end of a measurement in which collisions between particles are "
     "recorded for the impact spectra; 0 for none (with `recorder`)"},

    {"wear", "law", choice, defaulted, "\"archard\"", any, wear_laws,
     "the one law for all particles"},
    {"wear", "specific_wear_rate_per_pa", real, optional, "", above_up_to(0.0, 1e-6), "",
     "its k: volume lost per energy of the law's measure, K/H for Archard [1/Pa = m3/J]"},
    {"wear", "depth_rate_m_per_year", real, optional, "", above_up_to(0.0, 1.0), "",
     "with `law = \"corrosion\"`, in place of k: depth lost everywhere [m/year of milling]"},
    {"wear", "bins", integer, defaulted, "120", between(100, 10000), "",
     "bins along one pitch of the liner"},
    {"wear", "time_blocks", integer, defaulted, "10", between(2, 1000), "",
     "replicates of the load in one measurement"},
    {"wear", "smoothing", choice, defaulted, "\"penalised\"", any, "penalised|paper",
     "how the load is smoothed along the profile: `penalised` as much as its noise asks for, "
     "`paper` by the two splines of the 2006 paper"},
    {"wear", "excess_speed_m_per_s", real, defaulted, "0.1", between(0.0, 100.0), "",
     "speed of impact above which the excess kinetic energy counts [m/s]"},

    {"wear.mechanisms", "law", choice, required, "", any, wear_laws, "what the loss goes with"},
    {"wear.mechanisms", "specific_wear_rate_per_pa", real, optional, "", above_up_to(0.0, 1e-6), "",
     "k: volume lost per energy of the law's measure; for every law but corrosion "
     "[1/Pa = m3/J]"},
    {"wear.mechanisms", "depth_rate_m_per_year", real, optional, "", above_up_to(0.0, 1.0), "",
     "of corrosion, and only there: depth lost everywhere [m/year of milling]"},
    {"wear.mechanisms", "material", name, optional, "", any, "", "only particles of this material"},
    {"wear.mechanisms", "smallest_diameter_m", real, optional, "", positive, "",
     "only particles of this diameter and more [m]"},
    {"wear.mechanisms", "largest_diameter_m", real, optional, "", positive, "",
     "only particles of this diameter and less [m]"},

    {"campaign", "scheme", choice, defaulted, "\"threshold\"", any, "threshold|adaptive",
     "how the next DEM is timed: after a worn `threshold` (the 2006 paper), or by the error of the "
     "last step"},
    {"campaign", "threshold", real, defaulted, "0.15", above_up_to(0.0, 1.0), "",
     "worn share of the new lifter's volume per DEM load (with `threshold`) [-]"},
    {"campaign", "step_tolerance", real, defaulted, "0.005", above_up_to(0.0, 0.5), "",
     "share of the new lifter's volume that one DEM load may wear at the wrong place (with "
     "`adaptive`) [-]"},
    {"campaign", "largest_share", real, defaulted, "0.25", above_up_to(0.0, 10.0), "",
     "share of the new lifter's volume that one DEM load may wear at all (with `adaptive`) [-]"},
    {"campaign", "steps_per_cycle", integer, defaulted, "5", between(1, 1000), "",
     "geometry steps on one DEM load"},
    {"campaign", "height_limit_m", real, required, "", at_least(-10.0), "",
     "the liner is worn out at this lifter height, from where the plate was when new: below 0 the "
     "crest stands lower than the new plate did [m]"},
    {"campaign", "plate_limit_m", real, optional, "", at_least(0.0), "",
     "... or at this least plate thickness; a tenth of `plate_thickness_m` where missing [m]"},
    {"campaign", "cycle_limit", integer, defaulted, "50", between(1, 10000), "",
     "the campaign stops after so many cycles"},
    {"campaign", "reversal_hours", reals, optional, "", positive, "",
     "operating hours at which the mill is made to turn the other way, increasing; never where "
     "missing [h]"},

    {"gauge", "calibrate_until_hours", real, optional, "", positive, "",
     "`compare` and the report calibrate the campaign's hours on the heights read up to these "
     "operating hours and predict the later ones; not at all where missing [h]"},
};

}  // namespace

bool KeyRange::holds(double value) const {
  return std::isfinite(value) && (above_low ? value > low : value >= low) && value <= high;
}

std::string KeyRange::text() const {
  if (std::isinf(high)) {
    return std::isinf(low) ? "" : fmt::format("{} {}", above_low ? "above" : "at least", low);
  }
  return above_low ? fmt::format("above {} and up to {}", low, high)
                   : fmt::format("from {} to {}", low, high);
}

std::span<const TableSpec> case_tables() { return tables; }

std::span<const KeySpec> case_keys() { return keys; }

const KeySpec* find_key(std::string_view table, std::string_view key) {
  const auto found = std::find_if(std::begin(keys), std::end(keys), [&](const KeySpec& spec) {
    return spec.table == table && spec.key == key;
  });
  return found == std::end(keys) ? nullptr : found;
}

const TableSpec* find_table_spec(std::string_view table) {
  const auto found = std::find_if(tables.begin(), tables.end(),
                                  [&](const TableSpec& spec) { return spec.name == table; });
  return found == tables.end() ? nullptr : &*found;
}

std::string table_heading(const TableSpec& table) {
  if (table.name.empty()) {
    return "the top of the file";
  }
  return table.repeats ? fmt::format("[[{}]]", table.name) : fmt::format("[{}]", table.name);
}

}  // namespace millwear
