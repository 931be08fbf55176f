#include "mill/case_keys/dem_keys.h"

namespace millwear {
namespace {

using key::choice;
using key::deduced;
using key::defaulted;
using key::in;
using key::locked_unless_default;
using key::optional;
using Dem = DemSettings;

constexpr int steps_between_dumps = 20;
constexpr double most_in_least_revolutions = 4.0;

key::Place<Dem, double> target_error() {
  return {[](Dem& dem, double error) {
            dem.error_target = ErrorTarget{error, 0.0};
          },
          [](const Dem& dem) {
            return dem.error_target ? std::optional(dem.error_target->relative_error)
                                    : std::nullopt;
          }};
}

key::Place<Dem, double> most_revolutions() {
  return {[](Dem& dem, double most) {
            if (dem.error_target) dem.error_target->most_revolutions = most;
          },
          [](const Dem& dem) {
            return dem.error_target ? std::optional(dem.error_target->most_revolutions)
                                    : std::nullopt;
          }};
}

void most_from_least(Dem& dem) {
  most_revolutions().set(dem, most_in_least_revolutions * dem.measure_revolutions);
}

void sample_for_contact_path(Dem& dem) {
  if (dem.contact_path == ContactPath::dumps) dem.sample_every_steps = steps_between_dumps;
}

/// A row whose default depends on `charge_from`, so that the locked copy names it beside one.
KeyRow<Dem> locked_beside_a_charge(const KeyRow<Dem>& row) {
  KeyRow<Dem> locked = locked_unless_default(row);
  locked.written = [always = row.written, otherwise = locked.written](const Dem& dem) {
    return dem.charge_from ? always(dem) : otherwise(dem);
  };
  return locked;
}

}  // namespace

const std::vector<KeyRow<DemSettings>>& dem_keys() {
  static const auto rows = rows_of<Dem>(
      "dem",
      {defaulted("modulus_reduction", in(&Dem::modulus_reduction), at_least(1.0),
                 "the shear moduli are divided by this, for a longer time step [-]"),
       defaulted("rayleigh_fraction", in(&Dem::rayleigh_fraction), above_up_to(0.0, 0.5),
                 "time step as a share of the least Rayleigh time [-]"),
       optional("longest_time_step_s", in(&Dem::longest_time_step), positive,
                "the time step is never above this [s]"),
       optional("time_step_s", in(&Dem::time_step), positive,
                "time step in place of `rayleigh_fraction`, cut so that a pitch takes whole steps "
                "[s]"),
       choice(Presence::defaulted, "rolling_friction_model", in(&Dem::rolling_friction),
              {RollingFriction::cdt, RollingFriction::epsd2},
              "rolling friction: constant torque, or elastic-plastic spring-dashpot"),
       defaulted("mix_revolutions", in(&Dem::mix_revolutions), at_least(0.0),
                 "revolutions before the first measurement; with `mix_until_steady` the most"),
       locked_beside_a_charge(defaulted(
           "mix_until_steady", in(&Dem::mix_until_steady), any_value,
           "mixing ends as soon as torque and kinetic energy drift no longer (with `recorder`)")),
       defaulted("settle_pitches", in(&Dem::settle_pitches), between(0, 100000),
                 "pitches turned on a new mesh before the load is measured"),
       defaulted("measure_revolutions", in(&Dem::measure_revolutions), positive,
                 "revolutions over which the load is measured; with `target_relative_error` the "
                 "least number"),
       optional("target_relative_error", target_error(), above_up_to(0.0, 1.0),
                "a measurement goes on until the smoothed rate of loss at its peaks is known to "
                "this relative standard error (with `recorder`)"),
       deduced(
           optional("most_revolutions", most_revolutions(), positive,
                    "with `target_relative_error`: a measurement ends after so many revolutions in "
                    "any case; four times `measure_revolutions` where it is missing"),
           most_from_least),
       locked_unless_default(defaulted(
           "chunk_particle_steps", in(&Dem::chunk_particle_steps), at_least(1.0),
           "a mixing or a measurement of more particles times steps is simulated in chunks of "
           "whole pitches, and a stop costs one chunk at most (with `recorder`)")),
       choice(Presence::defaulted, "wall_contacts", in(&Dem::contact_path),
              {ContactPath::recorder, ContactPath::dumps},
              "how wall contacts are seen: `recorder` takes every step from inside LIGGGHTS, "
              "`dumps` samples through the text dumps of the plain `liggghts`"),
       deduced(optional("sample_every_steps", in(&Dem::sample_every_steps), between(1, 1000000),
                        "time steps between two samples of the wall contacts; 1 for the recorder "
                        "and 20 for dumps where it is missing"),
               sample_for_contact_path),
       defaulted("ranks", in(&Dem::ranks), between(0, 100000),
                 "MPI ranks; 0 takes every core that the program may use"),
       key::words(
           "launcher", &Dem::launcher,
           "how ranks are started: `mpirun`, `srun`, or words with `{ranks}` and `{command}`, "
           "such as `mpiexec -n {ranks} {command}`"),
       optional("skin_m", in(&Dem::skin), positive,
                "neighbour skin; the least particle's radius where it is missing [m]"),
       choice(
           Presence::optional, "rank_split", in(&Dem::rank_split),
           {RankSplit::charge, RankSplit::axis, RankSplit::balanced},
           "how ranks share the mill: an even number on either side of the moving `charge`'s "
           "middle (where it is missing; an odd number then in slabs), in slabs along the `axis`, "
           "or any number `balanced`, in columns with equally many particles (with `recorder`)"),
       locked_unless_default(defaulted(
           "tune", in(&Dem::tune), any_value,
           "`millwear run` chooses the neighbour skin and the split among ranks by a short trial "
           "on the mixed charge; in place of `skin_m` and `rank_split`")),
       defaulted("mesh_tolerance", in(&Dem::mesh_tolerance), above_up_to(0.0, 0.5),
                 "mesh against profile, share of the least particle radius [-]"),
       defaulted("seed", in(&Dem::seed), between(1, 2147483647), "seed of the first packing"),
       optional(
           "charge_from", in(&Dem::charge_from), any_value,
           "folder of a campaign, or of one of its cycles, whose charge the first mixing begins "
           "with in place of a packing, from the folder of this file; `mix_until_steady` is "
           "then true where it is missing"),
       defaulted("keep_dumps", in(&Dem::keep_dumps), any_value,
                 "keep the contact dumps (with `dumps`)"),
       defaulted("keep_events", in(&Dem::keep_events), any_value,
                 "keep a row for every collision with the liner, `events.h5` (with `recorder`)"),
       defaulted("pair_revolutions", in(&Dem::pair_revolutions), between(0.0, 100.0),
                 "revolutions at the end of a measurement in which collisions between particles "
                 "are recorded for the impact spectra; 0 for none (with `recorder`)")});
  return rows;
}

}  // namespace millwear
