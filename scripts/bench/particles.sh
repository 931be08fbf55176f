#!/bin/sh
# What a time step costs against the number of particles: the 8 m SAG mill with its sizes cut at 90
# to 22 mm, 40 % filled, and once a sixth filled. Every charge falls and is carried for 0.2 s, then
# some steps are timed, in turns. Prints the table and draws docs/cost_by_particles.png.
#   scripts/bench/particles.sh [rounds] [ranks]      idle machine, a core a rank
set -eu
cd "$(dirname "$0")/../.."
rounds=${1:-3} ranks=${2:-2}
fall_s=0.2
. scripts/bench/dem_timing.sh

# charge NAME CUT FILLING BALLS
charge() {
  sed -e "s/^truncate_below_m.*/truncate_below_m = $2/" -e "s/^total_filling.*/total_filling = $3/" \
    -e "s/^ball_filling.*/ball_filling = $4/" cases/seed_mill_8m_desktop/case.toml >"$work/$1.toml"
  $millwear deck "$work/$1.toml" --out "$work/$1" --ranks "$ranks" --quiet >/dev/null
  mix=$work/$1/cycle_000/mix
  fall=$(echo "$fall_s $(time_step "$mix")" | awk '{ print int($1 / $2) }')
  sed -e "s/^run .*/run $fall/" -e "s/^thermo  .*/thermo 1000/" "$mix/deck.in" >"$mix/fall.in"
  (cd "$mix" && $mpi "$recorder" run --in fall.in >log)
  sed -e "s|^read_data .*|read_restart charge.restart|" -e "s/^run .*/run 20\\nrun 200/" \
    -e "s/^thermo  .*/thermo 1000/" -e "/^write_restart/d" "$mix/deck.in" >"$mix/timed.in"
}
charges="few cut90 cut63 cut45 cut31 cut22"
charge few 0.089 0.16 0.06
charge cut90 0.089 0.40 0.149
charge cut63 0.063 0.40 0.149
charge cut45 0.045 0.40 0.149
charge cut31 0.0315 0.40 0.149
charge cut22 0.022 0.40 0.149

for round in $(seq "$rounds"); do
  for name in $charges; do
    mix=$work/$name/cycle_000/mix
    (cd "$mix" && $mpi "$recorder" run --in timed.in >log)
    awk '/^Loop time of/ { t = $4; steps = $9; n = $12 } /^Memory usage per processor/ { memory = $6 }
      END { print n, steps / t, memory }' "$mix/log" >>"$work/$name.times"
  done
done

printf '%10s %10s %24s %18s\n' particles "steps/s" "us a particle and step" "MiB a rank (lists)"
for name in $charges; do
  tail -1 "$work/$name.times" | awk -v speed="$(awk '{ print $2 }' "$work/$name.times" | median)" '
    { printf "%10d %10.1f %24.3f %18.0f\n", $1, speed, 1e6 / (speed * $1), $3 }' | tee -a "$work/table"
done
gnuplot -e "table='$work/table'" - <<'PLOT'
set terminal pngcairo size 900,560 font "sans,12"
set output "docs/cost_by_particles.png"
set logscale xy
set key top left
set xlabel "particles"
set ylabel "seconds a step"
set format xy "%g"
set xrange [2000:300000]
stats table using (log(1.0 / $2 / $1)) nooutput
slope = exp(STATS_mean)
plot table using 1:(1 / $2) with linespoints lw 2 pt 7 lc "#4c72b0" title "measured", \
     slope * x with lines dt 2 lc "gray" title "in proportion to the particles"
PLOT
