#!/bin/sh
# Filling a mill to 40 %: the packing that millwear makes, against a charge that falls from the top (the
# packing turned upside down), three seconds of each. Sizes are cut at 63 mm and contacts softened four
# times more, so that it takes minutes; what falls from the top may then pass through the liner and be lost.
#   scripts/bench/filling.sh [ranks]
# Steady is when the kinetic energy was last a quarter off its mean over the last fifth of the run.
set -eu
cd "$(dirname "$0")/../.."
ranks=${1:-2} seconds=3.0
. scripts/bench/dem_timing.sh

awk '/^modulus_reduction/ { $3 = 4 * $3 } /^truncate_below_m/ { $3 = 0.063 - 1e-6 } { print }' \
  cases/seed_mill_8m_desktop/case.toml >"$work/case.toml"
$millwear deck "$work/case.toml" --out "$work/run" --ranks "$ranks" --quiet >/dev/null
cd "$work/run/cycle_000/mix"
step=$(time_step .)
steps=$(awk -v s="$seconds" -v step="$step" 'BEGIN { print int(s / step) }')
sed -i -e "s/^run .*/run $steps/" -e "s/^thermo  .*/thermo $((steps / 300))/" -e '/^write_restart/d' \
  -e 's/lost error/lost ignore/' deck.in
awk '/^Atoms/ { on = 1 } on && NF == 7 { $7 = -$7 } { print }' charge.data >falling.data
sed 's/^read_data .*/read_data falling.data/' deck.in >falling.in

printf '%-24s %16s %16s %16s %8s\n' "" "steady after, s" "peak energy, kJ" "particles lost" "wall, s"
for way in deck falling; do
  $mpi "$recorder" run --in $way.in >$way.log
  [ $way = deck ] && printf '%-24s' "packed low" || printf '%-24s' "falling from the top"
  awk -v step="$step" '
    NF == 5 && $1 ~ /^[0-9]+$/ && $2 ~ /^[0-9]+$/ { n++; time[n] = $1 * step; energy[n] = $3; if (n == 1) all = $2; left = $2 }
    END { from = int(0.8 * n); for (i = from; i <= n; i++) mean += energy[i] / (n - from + 1)
      for (i = 1; i <= n; i++) { if (energy[i] > peak) peak = energy[i]
        if (energy[i] > 1.25 * mean || energy[i] < 0.75 * mean) steady = time[i] }
      printf " %16.2f %16.1f %16d", steady, peak / 1e3, all - left }' $way.log
  printf ' %8.0f\n' "$(loop_seconds $way.log)"
done
