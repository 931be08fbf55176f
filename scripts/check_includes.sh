#!/bin/sh
# Checks who includes whom: mill <- meshgen, liggghts_inputs, wear <- recorder, orchestrator.
# Each outside library stays in the few files that are named here. Prints what breaks a rule.
set -eu
cd "$(dirname "$0")/.."
broken=0

# room "rooms it may include from"
room() {
  [ -d "$1" ] || return 0
  rooms=$(echo "$1 $2" | sed 's/ /|/g')
  found=$(grep -rnE --include='*.h' --include='*.cpp' --include='*.in' \
    '^#include "(mill|meshgen|liggghts_inputs|wear|recorder|orchestrator)/' "$1" |
    grep -vE "#include \"($rooms)/" || true)
  [ -z "$found" ] || { echo "$1 may include only from: $1 $2"; echo "$found"; broken=1; }
}
room mill ""
room meshgen "mill"
room liggghts_inputs "mill"
room wear "mill"
room recorder "mill wear"
room orchestrator "mill meshgen liggghts_inputs wear"

# library "pattern of its headers" files that may include it
library() {
  name=$1 pattern=$2
  shift 2
  found=$(grep -rlE --include='*.h' --include='*.cpp' "#include <$pattern" \
    mill meshgen liggghts_inputs wear orchestrator $([ -d recorder ] && echo recorder) |
    grep -vE '/bench/' || true)
  for file in $found; do
    case " $* " in
      *" $file "*) ;;
      *) echo "$name may be included only by: $*"; echo "  and not by $file"; broken=1 ;;
    esac
  done
}
library gmsh "gmsh\.h" meshgen/gmsh_kernel.cpp
library dxflib "dxflib/|dl_" meshgen/dxf_polyline.cpp
library GSL "gsl/" wear/spline_basis.cpp wear/paper_spline.cpp wear/gsl_status.h
library HDF5 "hdf5|H5" wear/hdf5_file.cpp wear/load_read.cpp wear/load_write.cpp \
  wear/collision_store.cpp
library Clipper "polyclipping/|clipper" wear/steel_cut.cpp wear/area_between.cpp
library toml++ "toml" mill/case_document.cpp
library CLI11 "CLI/" orchestrator/command_line.cpp recorder/mixing_options.cpp \
  recorder/option_parsing.cpp recorder/recording_plan.cpp recorder/run_options.cpp
library LIGGGHTS "liggghts/" recorder/charge_census.cpp recorder/deck_run.cpp recorder/main.cpp recorder/mesh_hook.cpp \
  recorder/neighbours_by_size.cpp recorder/pair_contacts.cpp recorder/particle_neighbours.cpp \
  recorder/particle_neighbours.h recorder/steady_mixing_run.cpp recorder/stretch_recorder.cpp \
  recorder/touching_pairs.cpp recorder/wall_module.cpp recorder/wall_module.h recorder/wall_neighbours.cpp \
  $(echo recorder/contact_models/style_*_model.h)
library MPI "mpi\.h" recorder/main.cpp recorder/rank_exchange.h \
  recorder/steady_mixing_run.cpp recorder/stretch_recorder.h

# The wear laws, bins, smoothing and evolution are pure: no files, clock or randomness. The stores of
# loads and collisions are the exception.
impure=$(grep -nE '#include <(fstream|iostream|filesystem|chrono|random|cstdlib|unistd.h)>' \
  wear/*.h wear/*.cpp | grep -vE '^wear/(load_(store|read|write)|collision_store|hdf5_file)\.' || true)
[ -z "$impure" ] || { echo "wear is pure but for its stores:"; echo "$impure"; broken=1; }

exit $broken
