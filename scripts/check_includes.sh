#!/bin/sh
# Checks who includes whom, room by room and sub-room by sub-room, and that each outside library stays
# in the few files that are named here. Prints what breaks a rule.
#   scripts/check_includes.sh [folder of the sources]
set -eu
cd "${1:-$(dirname "$0")/..}"
broken=0

# Each room with the rooms it may include from. A room of this list may include from itself and from
# the rooms named; `mill` stands for all of its sub-rooms, likewise the others. Lowest first.
rooms='
mill/base:
mill/liner: mill/base
mill/case: mill/base mill/liner
mill/load: mill/base mill/liner mill/case
mill/recording: mill/base mill/load
mill/case_keys: mill/base mill/liner mill/case
mill/new_case: mill/base
mill/case_file: mill/base mill/liner mill/case mill/load mill/case_keys
meshgen/drawing: mill
meshgen: mill meshgen/drawing
liggghts_inputs/decks: mill
liggghts_inputs/outputs: mill liggghts_inputs/decks
wear/numerics: mill/base mill/liner
wear/hdf5: mill/base
wear/record: mill wear/numerics wear/hdf5
wear/charge: mill/base mill/liner wear/numerics wear/hdf5
wear/surface: mill wear/numerics wear/record
wear/rate: mill wear/numerics wear/record wear/surface
wear/evolve: mill wear/numerics wear/record wear/surface
wear/band: mill wear/numerics wear/surface wear/rate wear/evolve
wear/calibrate: mill wear/numerics wear/evolve
wear/gauge: mill wear/numerics wear/record wear/evolve
recorder/liggghts:
recorder/options: mill
recorder/balance: mill/base
recorder/neighbours: recorder/liggghts
recorder/pairs: mill/base recorder/liggghts
recorder/record: mill wear recorder/liggghts recorder/pairs
recorder/turning: recorder/liggghts
recorder/walls: recorder/liggghts
recorder/run: mill recorder/liggghts recorder/options recorder/balance recorder/neighbours recorder/pairs recorder/record recorder/turning recorder/walls
orchestrator/process: mill/base
orchestrator/drawing: mill meshgen/drawing wear/gauge
orchestrator/campaign: mill meshgen wear orchestrator/process
orchestrator/dem_run: mill liggghts_inputs wear orchestrator/process orchestrator/campaign
orchestrator/stretch: mill liggghts_inputs wear orchestrator/process orchestrator/campaign orchestrator/dem_run
orchestrator/loads: mill wear orchestrator/campaign
orchestrator/stages: mill wear orchestrator/process orchestrator/campaign orchestrator/dem_run orchestrator/stretch orchestrator/loads
orchestrator/charge: mill wear/charge orchestrator/campaign
orchestrator/results: mill wear orchestrator/campaign orchestrator/dem_run orchestrator/loads orchestrator/charge
orchestrator/report: mill/base mill/case mill/load wear/charge wear/record orchestrator/process orchestrator/charge orchestrator/results
orchestrator/pictures: mill wear orchestrator/process orchestrator/campaign orchestrator/charge orchestrator/loads orchestrator/results
orchestrator/vtk: mill/base
orchestrator/export: mill wear orchestrator/campaign orchestrator/loads orchestrator/results orchestrator/vtk
orchestrator/comparison: mill orchestrator/campaign orchestrator/charge orchestrator/results orchestrator/report orchestrator/pictures orchestrator/export
orchestrator/postprocess: mill meshgen liggghts_inputs/outputs wear orchestrator/process orchestrator/campaign orchestrator/dem_run
orchestrator/gauge: mill meshgen wear orchestrator/results
orchestrator/calibration: mill wear orchestrator/campaign orchestrator/dem_run orchestrator/results orchestrator/gauge
orchestrator/validation: mill orchestrator/campaign orchestrator/dem_run orchestrator/results
orchestrator/study: mill orchestrator/drawing liggghts_inputs wear orchestrator/process orchestrator/campaign orchestrator/dem_run orchestrator/loads orchestrator/results orchestrator/report
orchestrator/cluster: mill orchestrator/process orchestrator/campaign orchestrator/dem_run orchestrator/study
orchestrator/app: mill meshgen liggghts_inputs wear orchestrator
'

includes() {  # file:line:included path, of every quoted include of a room in a folder
  grep -rnoE --include='*.h' --include='*.cpp' --include='*.in' --exclude-dir=bench \
    '^#include "(mill|meshgen|liggghts_inputs|wear|recorder|orchestrator)/[^"]+' "$1" |
    sed 's/#include "//'
}

for place in mill/* meshgen/* meshgen liggghts_inputs/* wear/* recorder/* orchestrator/*; do
  [ -d "$place" ] && [ "$(basename "$place")" != bench ] || continue
  rule=$(echo "$rooms" | grep "^$place:" || true)
  if [ -z "$rule" ]; then
    echo "$place is a room without a rule; give it a line in $0"
    broken=1
    continue
  fi
  allowed=$(echo "$place ${rule#*:}" | tr -s ' ' '|' | sed 's/|$//')
  found=$(includes "$place" | grep -vE "^[^:]*:[^:]*:($allowed)/" || true)
  [ -z "$found" ] || { echo "$place may include only from:${rule#*:}"; echo "$found"; broken=1; }
done

# A source lies in a sub-room, with the header of its name; these have none.
loose=$(ls mill/*.cpp mill/*.h liggghts_inputs/*.cpp liggghts_inputs/*.h wear/*.cpp wear/*.h \
  recorder/*.cpp recorder/*.h orchestrator/*.cpp orchestrator/*.h 2>/dev/null || true)
[ -z "$loose" ] || { echo "these lie in no sub-room:"; echo "$loose"; broken=1; }
for source in $(find mill meshgen liggghts_inputs wear recorder orchestrator -name '*.cpp' ! -path '*/bench/*'); do
  case $source in
    */main.cpp | */print_*.cpp | orchestrator/app/*_verb.cpp) continue ;;
  esac
  [ -f "${source%.cpp}.h" ] || { echo "$source has no header of its name"; broken=1; }
done

# library "pattern of its headers" files that may include it
library() {
  name=$1 pattern=$2
  shift 2
  found=$(grep -rlE --include='*.h' --include='*.cpp' --exclude-dir=bench "#include <$pattern" \
    mill meshgen liggghts_inputs wear orchestrator recorder || true)
  for file in $found; do
    case " $* " in
      *" $file "*) ;;
      *) echo "$name may be included only by: $*"; echo "  and not by $file"; broken=1 ;;
    esac
  done
}
library gmsh "gmsh\.h" meshgen/gmsh_kernel.cpp
library dxflib "dxflib/|dl_" meshgen/drawing/dxf_polyline.cpp
library GDAL "(gdal_|ogr|cpl_)" meshgen/drawing/drawn_pieces.cpp
library GSL "gsl/" wear/numerics/spline_basis.cpp wear/numerics/paper_spline.cpp wear/numerics/gsl_status.h
library HDF5 "hdf5\.h|H5" $(echo wear/hdf5/*.cpp) wear/record/load_write.cpp wear/record/collision_store.cpp
library Clipper "polyclipping/|clipper" wear/evolve/steel_cut.cpp wear/gauge/area_between.cpp
library toml++ "toml" mill/case_keys/case_document.cpp
library dlib "dlib/" orchestrator/study/design_search.cpp
library zlib "zlib\.h" orchestrator/report/deflate.cpp
library cereal "cereal/" orchestrator/loads/kept_value.h
library CLI11 "CLI/" orchestrator/app/command_line.cpp orchestrator/app/common_options.cpp \
  orchestrator/app/slurm_options.cpp \
  orchestrator/app/liner_choice.cpp $(echo orchestrator/app/*_verb.cpp) recorder/options/mixing_options.cpp \
  recorder/options/option_parsing.cpp recorder/options/recording_plan.cpp \
  recorder/options/run_options.cpp
library LIGGGHTS "liggghts/" recorder/balance/balanced_columns.cpp recorder/record/charge_census.cpp recorder/record/charge_recorder.cpp recorder/run/deck_run.cpp \
  recorder/run/main.cpp recorder/record/liner_census.cpp recorder/record/mesh_hook.cpp recorder/neighbours/neighbours_by_size.cpp \
  recorder/liggghts/fix_makers.cpp recorder/turning/turning_mesh.cpp recorder/walls/near_walls.cpp \
  recorder/pairs/pair_contacts.cpp recorder/neighbours/particle_neighbours.cpp \
  recorder/neighbours/particle_neighbours.h recorder/run/steady_mixing_run.cpp \
  recorder/record/stretch_recorder.cpp recorder/pairs/touching_pairs.cpp \
  recorder/record/wall_module.cpp recorder/record/wall_module.h recorder/neighbours/wall_neighbours.cpp \
  $(echo recorder/pairs/contact_models/style_*_model.h)
library MPI "mpi\.h" recorder/balance/balanced_columns.cpp recorder/run/main.cpp recorder/record/rank_exchange.h recorder/record/charge_recorder.h \
  recorder/run/steady_mixing_run.cpp recorder/record/stretch_recorder.h

# A program that links the wear library need not describe a whole mill: no header of it reaches
# `Case`, neither itself nor through another.
reached=$(ls wear/*/*.h)
while :; do
  # shellcheck disable=SC2086  # the list is meant to be split
  more=$(grep -hoE '^#include "(mill|wear)/[^"]+' $reached | sed 's/#include "//')
  wider=$(printf '%s\n%s\n' "$reached" "$more" | sort -u)
  [ "$wider" != "$reached" ] || break
  reached=$wider
done
# shellcheck disable=SC2086
wholes=$(grep -nE '^#include "mill/case/case\.h"' $reached /dev/null || true)
[ -z "$wholes" ] || { echo "a header of wear takes in the whole case:"; echo "$wholes"; broken=1; }

# The wear library's computations are pure: no files, clock or randomness. Its stores are the exception.
impure=$(grep -nE '#include <(fstream|iostream|filesystem|chrono|random|cstdlib|unistd.h)>' -r wear \
  --include='*.h' --include='*.cpp' --exclude-dir=bench |
  grep -vE '^wear/(record/(load_(store|read|write)|collision_store)\.|charge/charge_record\.|hdf5/)' || true)
[ -z "$impure" ] || { echo "wear is pure but for its stores:"; echo "$impure"; broken=1; }

exit $broken
