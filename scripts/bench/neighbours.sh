#!/bin/sh
# What the search for neighbours by size and the loop over touching pairs are worth: steps a second of liggghts,
# with the usual skin and with a wider one (which builds its lists less often), against millwear-recorder, which
# moves the particles by the same bits, with the search alone and with both. Every mill turns by some pitches
# first, until its charge is thrown; then all take turns.
#   scripts/bench/neighbours.sh [rounds] [steps] [ranks]      idle machine, a core a rank
set -eu
cd "$(dirname "$0")/../.."
rounds=${1:-3} steps=${2:-200} ranks=${3:-2}
pitches=5 wider=1.8
. scripts/bench/dem_timing.sh

# mill NAME CASE STEPS: leaves the decks to be timed
mill() {
  echo "$3" >"$work/$1.steps"
  $millwear deck "$2" --out "$work/$1" --ranks "$ranks" --quiet >/dev/null
  mix=$work/$1/cycle_000/mix
  turn=$(awk -v pitches=$pitches -v rows="$(in_case "$work/$1" rows)" \
    -v revolutions="$(in_case "$work/$1" mix_revolutions)" '/^run/ { print int(pitches * $2 / (revolutions * rows) + 0.5) }' \
    "$mix/deck.in")
  (cd "$mix" && sed "s/^run .*/run $turn/" deck.in >turn.in && $mpi "$recorder" run --in turn.in >log)
  # On a restart the mesh begins anew, under a name of its own.
  (cd "$mix" && sed 's/liner_000_mix/liner_timed/g' contact_model.in >timed_model.in
    sed -e 's|^read_data .*|read_restart charge.restart|' -e 's/contact_model.in/timed_model.in/' \
      -e 's/liner_000_mix/liner_timed/g' -e '/^write_restart/d' -e "s/^run .*/run 50\\nrun $3/" deck.in >timed.in
    sed "/^pair_style/s/\$/ $own_pairs/" timed_model.in >own_pairs_model.in
    sed 's/timed_model.in/own_pairs_model.in/' timed.in >own_pairs.in
    awk -v wider=$wider '/^neighbor/ { $2 = wider * $2 } { print }' timed.in >wider.in)
}

rocks() { sed 's/0.00, 0.00, 0.66,/0.10, 0.10, 0.46,/' cases/seed_mill_8m_desktop/case.toml; }
rocks >"$work/rocks.toml"
mill pilot cases/pilot_mill/case.toml $((50 * steps))
mill desktop cases/seed_mill_8m_desktop/case.toml "$steps"
mill rocks "$work/rocks.toml" "$steps"
mill printed cases/seed_mill_8m/case.toml "$steps"

for round in $(seq "$rounds"); do
  for name in pilot desktop rocks printed; do
    cd "$work/$name/cycle_000/mix"
    $mpi liggghts -in timed.in -log none >log && a=$(loop_seconds log)
    $mpi liggghts -in wider.in -log none >log && b=$(loop_seconds log)
    $mpi "$recorder" run --in own_pairs.in >log && c=$(loop_seconds log)
    $mpi "$recorder" run --in timed.in >log && d=$(loop_seconds log)
    echo "$a $b $c $d" >>"$work/$name.times"
  done
done

# row NAME TEXT: medians of steps a second, and of the recorder's against the better of liggghts's two
row() {
  printf '%-44s' "$2"
  for k in 1 2 3 4; do
    printf ' %12.1f' "$(awk -v k=$k -v steps="$(cat "$work/$1.steps")" '{ print steps / $k }' "$work/$1.times" | median)"
  done
  for k in 3 4; do
    printf ' %8.2f' "$(awk -v k=$k '{ print ($1 < $2 ? $1 : $2) / $k }' "$work/$1.times" | median)"
  done
  echo
}
printf '%-44s %12s %12s %12s %12s %8s %8s\n' "steps/s; load $(cut -d' ' -f1 /proc/loadavg)" liggghts "wider skin" \
  "by size" "touching" "by size" both
row pilot "pilot mill"
row desktop "8 m mill, 40 % filled, 45 to 90 mm"
row rocks "the same with its rocks of 122 and 180 mm"
row printed "8 m mill, counts as printed, 22 to 180 mm"
