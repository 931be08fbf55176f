#!/bin/sh
# What a time step costs against the number of particles: the 8 m SAG mill with its sizes cut at 90
# to 22 mm, 40 % filled, and once a sixth filled. Every charge falls and is carried for 0.35 s, then
# some steps are timed, in turns. Prints the table and draws docs/cost_by_particles.png.
#   scripts/bench/particles.sh [rounds] [ranks]      idle machine, a core a rank
set -eu
cd "$(dirname "$0")/../.."
rounds=${1:-3} ranks=${2:-2}
case=cases/seed_mill_8m_desktop/case.toml
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=""; [ "$(id -u)" -ne 0 ] || root=--allow-run-as-root
mpi="mpirun -np $ranks --bind-to none $root"

make -s build
millwear=$PWD/build/release/millwear

# charge NAME CUT FILLING BALLS
charge() {
  sed -e "s/^truncate_below_m.*/truncate_below_m = $2/" -e "s/^total_filling.*/total_filling = $3/" \
    -e "s/^ball_filling.*/ball_filling = $4/" -e "/^tune/d" \
    -e "s/^mix_revolutions.*/mix_revolutions = 2.0\\nskin_m = $(echo "$2" | awk '{ print 0.425 * $1 }')/" \
    "$case" >"$work/$1.toml"
  $millwear deck "$work/$1.toml" --out "$work/$1" --quiet >/dev/null
  cd "$work/$1/cycle_000/mix"
  step=$(awk '/^timestep/ { print $2 }' contact_model.in)
  fall=$(awk -v step="$step" 'BEGIN { print int(0.35 / step) }')
  sed -e "s/^run .*/run $fall/" -e "s/^thermo  .*/thermo 1000/" deck.in >fall.in
  $mpi liggghts -in fall.in -log none >log
  sed -e "s|^read_data .*|read_restart charge.restart|" -e "s/^run .*/run 20\\nrun 200/" \
    -e "s/^thermo  .*/thermo 1000/" -e "/^write_restart/d" deck.in >timed.in
  cd - >/dev/null
}
charge few 0.089 0.16 0.06
charge cut90 0.089 0.40 0.149
charge cut63 0.063 0.40 0.149
charge cut45 0.045 0.40 0.149
charge cut31 0.0315 0.40 0.149
charge cut22 0.022 0.40 0.149

for round in $(seq "$rounds"); do
  for name in few cut90 cut63 cut45 cut31 cut22; do
    log=$work/$name/cycle_000/mix/log
    (cd "$work/$name/cycle_000/mix" && $mpi liggghts -in timed.in -log none >log)
    awk -v name=$name -v round="$round" '/^Loop time of/ { t = $4; steps = $9; n = $12 }
      /^Memory usage per processor/ { memory = $6 }
      END { print name, n, steps / t, memory }' "$log" >>"$work/times"
  done
done

sort -k2,2n -k3,3g "$work/times" | awk -v rounds="$rounds" '
  { v[++k] = $3; if (k == rounds) { m = (v[int((k + 1) / 2)] + v[int(k / 2) + 1]) / 2
      print $2, m, 1e6 / (m * $2), $4; k = 0 } }' >"$work/table"
printf '%10s %10s %24s %18s\n' particles "steps/s" "us a particle and step" "MiB a rank (lists)"
awk '{ printf "%10d %10.1f %24.3f %18.0f\n", $1, $2, $3, $4 }' "$work/table"
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
