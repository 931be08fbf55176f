#!/bin/sh
# What the deck's settings are worth, on the seed mill as printed (26,765 particles): from the deck
# that one writes first (a mesh of 100 facets a pitch, `processors 2 1 1`, skin 10 mm, `epsd2`) to the
# one that millwear writes, one change at a time. Every deck goes on from the same charge in flight;
# they take turns, so that what else the machine does hits all alike. Then the two ways to fill.
#   scripts/bench/deck.sh [rounds] [steps] [ranks]      idle machine, a core a rank
set -eu
cd "$(dirname "$0")/../.."
rounds=${1:-5} steps=${2:-300} ranks=${3:-2}
pitches=6
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=""; [ "$(id -u)" -ne 0 ] || root=--allow-run-as-root
mpi="mpirun -np $ranks --bind-to none $root"

make -s build
millwear=$PWD/build/release/millwear
case=$PWD/cases/seed_mill_8m/case.toml
$millwear deck "$case" --out "$work/ours" --quiet >/dev/null
ours=$work/ours/cycle_000
step=$(awk '/^timestep/ { print $2 }' "$ours/mix/contact_model.in")
per_pitch=$(awk '/^run/ { print int($2 / 104 + 0.5) }' "$ours/mix/deck.in")   # two revolutions

# A mesh cut into 100 even pieces a pitch, as one would make it to hold the wear's bins.
awk -F, -v rows=52 -v plate=3.9005 -v width=0.25 '
  /^[-0-9]/ { n++; x[n] = $1; y[n] = $2; s[n] = n > 1 ? s[n-1] + sqrt((x[n]-x[n-1])^2 + (y[n]-y[n-1])^2) : 0 }
  function corner(i, row, at,   a, r, u, j, t) {
    t = s[n] * i / 100; j = 1; while (j < n - 1 && s[j+1] < t) j++
    u = (t - s[j]) / (s[j+1] - s[j])
    a = atan2(x[j] + u * (x[j+1] - x[j]), plate - y[j] - u * (y[j+1] - y[j]))
    r = sqrt((x[j] + u * (x[j+1] - x[j]))^2 + (plate - y[j] - u * (y[j+1] - y[j]))^2)
    a -= row * 8 * atan2(1, 1) / rows
    return sprintf("%.12g %.12g %.12g", -r * sin(a), at, -r * cos(a))
  }
  function triangle(a, b, c) {
    printf "facet normal 0 0 0\nouter loop\nvertex %s\nvertex %s\nvertex %s\nendloop\nendfacet\n", a, b, c
  }
  END { print "solid fine"
    for (row = 0; row < rows; row++) for (i = 0; i < 100; i++) {
      triangle(corner(i, row, 0), corner(i, row, width), corner(i + 1, row, 0))
      triangle(corner(i + 1, row, 0), corner(i, row, width), corner(i + 1, row, width))
    }
    print "endsolid fine" }' "$ours/mesh/profile.csv" >"$work/fine.stl"

# The charge in flight, as a data file that every deck can read whatever its models.
cd "$ours/mix"
sed "s/^run .*/dump end all custom $((pitches * per_pitch)) end.dump id type radius density x y z vx vy vz omegax omegay omegaz\\
dump_modify end first no sort id format \"%d %d %.9g %.9g %.12g %.12g %.12g %.9g %.9g %.9g %.9g %.9g %.9g\"\\
run $((pitches * per_pitch))/" deck.in >fly.in
echo "mixing $((pitches * per_pitch)) steps on $ranks ranks"
$mpi liggghts -in fly.in -log none >log
{ sed '/^Atoms/,$d' charge.data
  for part in Atoms Velocities; do
    printf '\n%s\n\n' $part
    awk -v part=$part '/^ITEM: ATOMS/ { on = 1; next } /^ITEM/ { on = 0 }
      on && part == "Atoms" { print $1, $2, 2 * $3, $4, $5, $6, $7 }
      on && part == "Velocities" { print $1, $8, $9, $10, $11, $12, $13 }' end.dump
  done; } >flying.data

# deck NAME MESH GRID SKIN ROLLING
deck() {
  mkdir -p "$work/$1"
  sed -e "s|file [^ ]*\.stl|file $2|" -e "s/rolling_friction [a-z0-9]*/rolling_friction $5/" \
    contact_model.in >"$work/$1/contact_model.in"
  sed -e "s/^processors .*/processors $3/" -e "s/^neighbor .*/neighbor $4 bin/" \
    -e "s|^read_data .*|read_data $ours/mix/flying.data|" -e "/^write_restart/d" \
    -e "s/^run .*/run 100\\nrun $steps/" deck.in >"$work/$1/deck.in"
}
mesh=$ours/mesh/liner.stl
skin=$(awk '/^neighbor/ { print $2 }' deck.in)
rolling=$(sed -n 's/.*rolling_friction \([a-z0-9]*\).*/\1/p' contact_model.in | tail -1)
deck first "$work/fine.stl" "$ranks 1 1" 0.010 epsd2
deck mesh  "$mesh"          "$ranks 1 1" 0.010 epsd2
deck ranks "$mesh"          "1 $ranks 1" 0.010 epsd2
deck skin  "$mesh"          "1 $ranks 1" "$skin" epsd2
deck ours  "$mesh"          "1 $ranks 1" "$skin" "$rolling"
cd "$work"

echo "round: seconds of $steps steps of the first deck, + mesh, + ranks along the axis, + skin $skin m, + $rolling; load $(cut -d' ' -f1 /proc/loadavg)"
for round in $(seq "$rounds"); do
  times=""
  for name in first mesh ranks skin ours; do
    (cd "$name" && $mpi liggghts -in deck.in -log none >log)
    times="$times $(awk '/^Loop time of/ { t = $4 } END { print t }' "$name/log")"
  done
  echo "$times" >>times
  echo "$round:$times"
done

awk -v steps="$steps" -v step="$step" '
  function median(k,   i, j, t, v) {
    for (i = 1; i <= NR; i++) v[i] = k < 0 ? time[i, 1] / time[i, -k] : time[i, k]
    for (i = 1; i <= NR; i++) for (j = i + 1; j <= NR; j++) if (v[j] < v[i]) { t = v[i]; v[i] = v[j]; v[j] = t }
    return (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2
  }
  { for (k = 1; k <= 5; k++) time[NR, k] = $k }
  END {
    split("the deck one writes first|+ mesh as coarse as the shape allows|+ ranks along the axis|+ skin|+ rolling friction that is optimised", name, "|")
    printf "\n%-40s %8s %14s %8s %12s\n", "", "steps/s", "sim. s an hour", "factor", "of the last"
    for (k = 1; k <= 5; k++) {
      printf "%-40s %8.1f %14.2f %8.2f %12.2f\n", name[k], steps / median(k), 3600 * step * steps / median(k),
        median(-k), k > 1 ? median(k - 1) / median(k) : 1
    }
  }' times

# Filling: the packing that millwear makes, against a charge that falls from the top (the packing
# turned upside down), with contacts softened ten times more so that it takes minutes. Steady is when
# the kinetic energy was last a quarter off its mean over the last fifth of the run.
sed 's/^modulus_reduction.*/modulus_reduction = 1000.0/' "$case" >soft.toml
$millwear deck soft.toml --out "$work/soft" --quiet >/dev/null
cd "$work/soft/cycle_000/mix"
steps=$(awk '/^run/ { print int($2 / 2 * 0.4) }' deck.in)
sed -i -e "s/^run .*/run $steps/" -e "s/^thermo  .*/thermo $((steps / 200))/" -e '/^write_restart/d' deck.in
awk '/^Atoms/ { on = 1 } on && NF == 7 { $7 = -$7 } { print }' charge.data >falling.data
sed 's/^read_data .*/read_data falling.data/' deck.in >falling.in
printf '\n%-40s %16s %16s\n' "" "steady after, s" "peak energy, kJ"
for fill in deck falling; do
  $mpi liggghts -in $fill.in -log none >$fill.log
  [ $fill = deck ] && printf '%-40s' "packed low" || printf '%-40s' "falling from the top"
  awk -v step="$(awk '/^timestep/ { print $2 }' contact_model.in)" '
    NF == 5 && $1 ~ /^[0-9]+$/ && $2 ~ /^[0-9]+$/ { n++; time[n] = $1 * step; energy[n] = $3 }
    END { from = int(0.8 * n); for (i = from; i <= n; i++) mean += energy[i] / (n - from + 1)
      for (i = 1; i <= n; i++) { if (energy[i] > peak) peak = energy[i]
        if (energy[i] > 1.25 * mean || energy[i] < 0.75 * mean) steady = time[i] }
      printf " %16.2f %16.1f\n", steady, peak / 1e3 }' $fill.log
done
