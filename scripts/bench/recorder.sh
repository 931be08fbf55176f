#!/bin/sh
# What recording costs: the seed mill as printed (26,765 particles), the same deck by turns run
# alone, recorded, recorded with a row a collision, and with the charge, all by the same program. Prints each
# round and ends with the ratios of the run times and the seconds that writing the results takes.
#   scripts/bench/recorder.sh [rounds] [steps] [ranks]      idle machine, a core a rank
set -eu
cd "$(dirname "$0")/../.."
rounds=${1:-25} steps=${2:-300} ranks=${3:-2}
mixing=6000 settle=100
. scripts/bench/dem_timing.sh

$millwear deck cases/seed_mill_8m/case.toml --out "$work" --quiet >/dev/null
sed -i "s/^run .*/run $mixing/" "$work/cycle_000/mix/deck.in"
deck=$work/cycle_000/dem/deck.in
awk -v settle=$settle -v steps="$steps" '/^run/ { n++; if (n == 1) print "run", settle;
  if (n == 2) print "run", steps; next } /^# \.\.\. and from here/ { next } { print }' "$deck" >"$deck.short"

echo "mixing $mixing steps on $ranks ranks"
(cd "$work/cycle_000/mix" && $mpi "$recorder" run --in deck.in >log)

case=$PWD/cases/seed_mill_8m/case.toml
record="$recorder --in deck.in.short --case $case --liner ../mesh/profile.csv --load load.h5
  --after $settle --until $((settle + steps))"

# seconds of the measuring run's loop, and of the whole program
timed() {
  start=$(date +%s.%N)
  (cd "$work/cycle_000/dem" && $mpi "$@" >log)
  end=$(date +%s.%N)
  echo "$(loop_seconds "$work/cycle_000/dem/log") $(echo "$end $start" | awk '{ print $1 - $2 }')"
}

echo "round: seconds of $steps steps plain, recorded, with events, with charge; load $(cut -d' ' -f1 /proc/loadavg)"
for round in $(seq "$rounds"); do
  plain=$(timed "$recorder" run --in deck.in.short)
  recorded=$(timed $record)
  events=$(timed $record --events events.h5)
  charge=$(timed $record --charge charge.h5)
  echo "$round $plain $recorded $events $charge" | tee -a "$work/times" |
    awk '{ printf "%d: %.2f  %.2f  %.2f  %.2f\n", $1, $2, $4, $6, $8 }'
done

# median of a column of ratios, and the middle half of them
middle() {
  sort -g | awk '{ v[NR] = $1 } END { m = (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2
    printf "%.4f (middle half %.3f to %.3f)\n", m, v[int(NR / 4) + 1], v[NR - int(NR / 4)] }'
}
printf 'recorded / plain     '; awk '{ print $4 / $2 }' "$work/times" | middle
printf 'with events / plain  '; awk '{ print $6 / $2 }' "$work/times" | middle
printf 'with charge / recorded'; awk '{ print $8 / $4 }' "$work/times" | middle
printf 'seconds to write the load, once a stretch    '
awk '{ print ($5 - $4) - ($3 - $2) }' "$work/times" | middle
printf '... and the events                           '
awk '{ print ($7 - $6) - ($3 - $2) }' "$work/times" | middle
printf '... and the charge                           '
awk '{ print ($9 - $8) - ($5 - $4) }' "$work/times" | middle
