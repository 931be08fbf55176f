#!/bin/sh
# What does DEM time buy? The life of the pilot mill with loads of four lengths, two seeds each: half
# the 95 % band of the life against the particle steps of a campaign, as predicted and by the seeds.
# Prints the table and draws PICTURE. Runs what is missing in FOLDER, so the same command resumes it.
#   scripts/studies/band_by_dem.sh FOLDER PICTURE.png
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
millwear=${MILLWEAR:-$here/build/release/millwear}
folder=${1:?usage: band_by_dem.sh FOLDER PICTURE.png} picture=${2:?usage: band_by_dem.sh FOLDER PICTURE.png}
"$millwear" study "$here/cases/pilot_mill/case.toml" --axis dem.measure_revolutions=0.1875,0.375,0.75,1.5 \
  --axis dem.seed=1,2 --jobs 2 --out "$folder" --quiet >/dev/null
table=$(mktemp)
trap 'rm -f "$table"' EXIT
awk -F, '
  /^point/ { for (i = 1; i <= NF; i++) column[$i] = i; next }
  /^[0-9]/ { n = $column["done"]; life = $column["life_hours"]
    printf "%s %.3g %.0f %.2f %.2f\n", $2, $column["dem_particle_steps"], life,
      196 * $column["life_hours_se"] * sqrt(n) / life, 196 * $column["life_hours_scatter"] / life }' \
  "$folder/study.csv" >"$table"
{ echo "revolutions|particle steps|life, h|half band, %|1.96 scatter, %"; tr ' ' '|' <"$table"; } | column -t -s '|'
gnuplot -e "table='$table'; picture='$picture'" - <<'PLOT'
set terminal pngcairo size 900,520 font "sans,12"
set output picture
set fit quiet
set logscale xy
set key top right
set xlabel "particle steps of a campaign"
set ylabel "half the 95 % band of the life [%]"
set format x "%.0e"
set yrange [1:30]
f(x) = a / sqrt(x)
a = 1e5
fit f(x) table using 2:4 via a
plot table using 2:4 with linespoints lw 2 pt 7 lc "#16365c" title "predicted", \
     table using 2:5 with points pt 6 ps 1.4 lw 2 lc "#a8431c" title "1.96 times the scatter of two seeds", \
     f(x) with lines dt 2 lc "gray" title "one over the root of the DEM"
PLOT
