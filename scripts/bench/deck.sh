#!/bin/sh
# What the deck's settings are worth, on the seed mill as printed (26,765 particles): from the deck
# that one writes first (a mesh of 100 facets a pitch, `processors 2 1 1`, skin 10 mm, `epsd2`, run by
# liggghts) to the one that millwear writes and runs, one change at a time; as the charge is packed, and
# once it is thrown. All decks go on from the same charge; they take turns, so that what else the machine
# does hits all alike.
#   scripts/bench/deck.sh [rounds] [steps] [ranks]      idle machine, a core a rank, an even number
set -eu
cd "$(dirname "$0")/../.."
rounds=${1:-5} steps=${2:-300} ranks=${3:-2}
pitches=6    # until the charge has come down and is thrown; whole ones, for the mesh starts anew
facets=100   # a pitch, of the first mesh
case=$PWD/cases/seed_mill_8m/case.toml
. scripts/bench/dem_timing.sh

$millwear deck "$case" --out "$work/ours" --ranks "$ranks" --quiet >/dev/null
ours=$work/ours/cycle_000
step=$(time_step "$ours/mix")
fall=$(awk -v pitches=$pitches -v rows="$(in_case "$work/ours" rows)" \
  -v revolutions="$(in_case "$work/ours" mix_revolutions)" '/^run/ { print int(pitches * $2 / (revolutions * rows) + 0.5) }' \
  "$ours/mix/deck.in")

# A mesh cut into even pieces, as one would make it to hold the wear's bins.
awk -F, -v facets=$facets -v rows="$(in_case "$work/ours" rows)" -v width="$(in_case "$work/ours" slice_length_m)" \
    -v shell="$(in_case "$work/ours" shell_diameter_m)" -v thick="$(in_case "$work/ours" plate_thickness_m)" '
  BEGIN { plate = shell / 2 - thick; full = 8 * atan2(1, 1) }
  /^[-0-9]/ { n++; x[n] = $1; y[n] = $2; s[n] = n > 1 ? s[n-1] + sqrt((x[n]-x[n-1])^2 + (y[n]-y[n-1])^2) : 0 }
  function corner(i, row, at,   a, r, u, j, t, px, py) {
    t = s[n] * i / facets; j = 1; while (j < n - 1 && s[j+1] < t) j++
    u = (t - s[j]) / (s[j+1] - s[j]); px = x[j] + u * (x[j+1] - x[j]); py = plate - y[j] - u * (y[j+1] - y[j])
    a = atan2(px, py) - row * full / rows; r = sqrt(px^2 + py^2)
    return sprintf("%.12g %.12g %.12g", -r * sin(a), at, -r * cos(a))
  }
  function triangle(a, b, c) {
    printf "facet normal 0 0 0\nouter loop\nvertex %s\nvertex %s\nvertex %s\nendloop\nendfacet\n", a, b, c
  }
  END { print "solid fine"
    for (row = 0; row < rows; row++) for (i = 0; i < facets; i++) {
      triangle(corner(i, row, 0), corner(i, row, width), corner(i + 1, row, 0))
      triangle(corner(i + 1, row, 0), corner(i, row, width), corner(i + 1, row, width))
    }
    print "endsolid fine" }' "$ours/mesh/profile.csv" >"$work/fine.stl"

# The charge in flight, as a data file that every deck can read whatever its models.
cd "$ours/mix"
sed "s/^run .*/dump end all custom $fall end.dump id type radius density x y z vx vy vz omegax omegay omegaz\\
dump_modify end first no sort id format \"%d %d %.9g %.9g %.12g %.12g %.12g %.9g %.9g %.9g %.9g %.9g %.9g\"\\
run $fall/" deck.in >fly.in
echo "$fall steps on $ranks ranks until the charge is thrown"
$mpi "$recorder" run --in fly.in >log
{ sed '/^Atoms/,$d' charge.data
  for part in Atoms Velocities; do
    printf '\n%s\n\n' $part
    tail -n "$(awk '/ atoms$/ { print $1 }' charge.data)" end.dump | awk -v part=$part '
      part == "Atoms" { print $1, $2, 2 * $3, $4, $5, $6, $7 }
      part == "Velocities" { print $1, $8, $9, $10, $11, $12, $13 }'
  done; } >thrown.data
cp charge.data packed.data

# The box that puts the charge in its middle, and one even around the mill.
for state in packed thrown; do
  awk '/xlo xhi$/ { $1 = -$2 } { print }' $state.data >${state}_even.data
done

# deck NAME MESH CHARGE GRID ROLLING SKIN [OPTION of the pairs]
deck() {
  mkdir -p "$work/$1"
  sed -e "s|file [^ ]*\.stl|file $2|" -e "s/rolling_friction [a-z0-9]*/rolling_friction $5/" \
    -e "/^pair_style/s/\$/ ${7:-}/" contact_model.in >"$work/$1/contact_model.in"
  sed -e "s/^processors .*/processors $4/" -e "s/^neighbor .*/neighbor $6 bin/" \
    -e "s|^read_data .*|read_data $ours/mix/$3|" -e "/^write_restart/d" \
    -e "s/^run .*/run 100\\nrun $steps/" deck.in >"$work/$1/deck.in"
}
mesh=$ours/mesh/liner.stl
skin=$(awk '/^neighbor/ { print $2 }' deck.in)
rolling=$(sed -n 's/.*rolling_friction \([a-z0-9]*\).*/\1/p' contact_model.in | tail -1)
grid=$(awk '/^processors/ { print $2, $3, $4 }' deck.in)
decks="first mesh split rolling search pairs ours"

write_decks() {
  deck first   "$work/fine.stl" "$1_even.data" "$ranks 1 1" epsd2      0.010
  deck mesh    "$mesh"          "$1_even.data" "$ranks 1 1" epsd2      0.010
  deck split   "$mesh"          "$1.data"      "$grid"      epsd2      0.010
  deck rolling "$mesh"          "$1.data"      "$grid"      "$rolling" 0.010
  deck search  "$mesh"          "$1.data"      "$grid"      "$rolling" 0.010 "$own_pairs"
  deck pairs   "$mesh"          "$1.data"      "$grid"      "$rolling" 0.010
  deck ours    "$mesh"          "$1.data"      "$grid"      "$rolling" "$skin"
}

# run_deck NAME: millwear's own program from where its search for neighbours comes in
run_deck() {
  case $1 in
    search | pairs | ours) $mpi "$recorder" run --in deck.in >log ;;
    *) $mpi liggghts -in deck.in -log none >log ;;
  esac
}

take_turns() {
  for round in $(seq "$rounds"); do
    line=""
    for name in $decks; do
      (cd "$work/$name" && run_deck "$name")
      line="$line $(loop_seconds "$work/$name/log")"
    done
    echo "$line" >>"$1"
    echo "$round:$line"
  done
}

# row TIMES COLUMN NAME: medians of the seconds, of the first deck's over these, and of the deck's before
row() {
  seconds=$(awk -v k="$2" '{ print $k }' "$1" | median)
  factor=$(awk -v k="$2" '{ print $1 / $k }' "$1" | median)
  gained=$(awk -v k="$2" '{ print (k > 1 ? $(k - 1) : $1) / $k }' "$1" | median)
  echo "$seconds $factor $gained" | awk -v name="$3" -v steps="$steps" -v step="$step" '
    { printf "%-40s %8.1f %14.2f %8.2f %12.2f\n", name, steps / $1, 3600 * step * steps / $1, $2, $3 }'
}

for state in packed thrown; do
  cd "$ours/mix"
  write_decks $state
  printf '\nThe charge %s; load %s; seconds of %s steps of the first deck and of each below\n' \
    $state "$(cut -d' ' -f1 /proc/loadavg)" "$steps"
  times=$work/$state.times
  take_turns "$times"
  printf '%-40s %8s %14s %8s %12s\n' "" steps/s "sim. s an hour" factor "of the last"
  row "$times" 1 "the deck one writes first"
  row "$times" 2 "+ mesh as coarse as the shape allows"
  row "$times" 3 "+ ranks split as $grid"
  row "$times" 4 "+ rolling friction by $rolling"
  row "$times" 5 "+ neighbours by size"
  row "$times" 6 "+ only pairs that touch"
  row "$times" 7 "+ skin of $skin m"
done
