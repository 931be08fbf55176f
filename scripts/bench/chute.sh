#!/bin/sh
# Particle steps a second of one core on a bed of 32,000 equal spheres that flows down a slope of 26 degrees, as in
# the `chute` benchmark of LAMMPS, with Hertz springs, tangential history and rolling friction: liggghts against
# millwear-recorder, and against an other recorder OTHER where that is given. All take turns. The bed settles first
# (some minutes), and is kept in FOLDER for the next time.
#   scripts/bench/chute.sh FOLDER [rounds] [steps] [OTHER]      idle machine
set -eu
mkdir -p "$1" && folder=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."
rounds=${2:-3} steps=${3:-500} other=${4:-} ranks=1
. scripts/bench/dem_timing.sh

models() {
  cat <<MODELS
hard_particles yes
neighbor      0.0015 bin
neigh_modify  delay 0
fix young     all property/global youngsModulus peratomtype 5e6
fix poisson   all property/global poissonsRatio peratomtype 0.3
fix rebound   all property/global coefficientRestitution peratomtypepair 1 0.5
fix sliding   all property/global coefficientFriction peratomtypepair 1 0.5
fix rolling   all property/global coefficientRollingFriction peratomtypepair 1 0.01
pair_style    gran model hertz tangential history rolling_friction cdt
pair_coeff    * *
timestep      1e-5
fix floor     all wall/gran model hertz tangential history rolling_friction cdt primitive type 1 zplane 0.0
fix integrate all nve/sphere
MODELS
}
head_of_deck="atom_style granular
atom_modify map array
communicate single vel yes
boundary p p f
newton off
units si"

if [ ! -e "$folder/bed.restart" ]; then
  { echo "$head_of_deck"
    echo "region bed block 0 0.4 0 0.2 -0.005 0.6 units box"
    echo "create_box 1 bed"
    echo "lattice sc 0.01"
    echo "region filled block 0 0.4 0 0.2 0.005 0.405 units box"
    echo "create_atoms 1 region filled"
    echo "set group all diameter 0.0098 density 2500"
    echo "displace_atoms all random 0.0001 0.0001 0.0001 15485863"
    models
    echo "fix gravity all gravity 9.81 chute 26.0"
    echo "thermo 2000"
    echo "thermo_style custom step atoms ke"
    echo "run 20000"
    echo "write_restart bed.restart"; } >"$folder/settle.in"
  (cd "$folder" && $mpi "$recorder" run --in settle.in >settle.log) || { tail -3 "$folder/settle.log"; exit 1; }
fi
{ echo "$head_of_deck"
  echo "read_restart bed.restart"
  models
  echo "fix gravity all gravity 9.81 chute 26.0"
  echo "thermo 1000"
  echo "run 50"
  echo "run $steps"; } >"$folder/timed.in"
cd "$folder"
particles=$(sed -n 's/.*steps with \([0-9]*\) atoms.*/\1/p' settle.log | tail -1)
for round in $(seq "$rounds"); do
  $mpi liggghts -in timed.in -log none >log && echo "liggghts $(loop_seconds log)"
  [ -z "$other" ] || { $mpi "$other" run --in timed.in >log && echo "other $(loop_seconds log)"; }
  $mpi "$recorder" run --in timed.in >log && echo "recorder $(loop_seconds log)"
done >times
for program in liggghts other recorder; do
  awk -v program=$program '$1 == program { print $2 }' times | median 2>/dev/null |
    awk -v program=$program -v work="$(awk -v p="$particles" -v s="$steps" 'BEGIN { print p * s }')" \
      '$1 > 0 { printf "%-9s %.2f million particle steps a second\n", program, work / $1 / 1e6 }'
done
