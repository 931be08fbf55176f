#!/bin/sh
# What does DEM time buy? The life of the pilot mill with loads of four lengths, two seeds each: half
# the 95 % band of the life against the particle steps of a campaign, and beside it the scatter of the
# kept campaigns that differ in the seed. Prints the table and draws PICTURE. Runs what is missing in
# FOLDER, so the same command resumes it.
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
    printf "%s %.3g %.0f %.1f\n", $2, $column["dem_particle_steps"], life,
      196 * $column["life_hours_se"] * sqrt(n) / life }' "$folder/study.csv" >"$table"
{ echo "revolutions|particle steps|life, h|half band, %"; tr ' ' '|' <"$table"; } | column -t -s '|'
# Particle steps of the case's own length of load, and 1.96 times the scatter of lives with its error, in per cent.
usual=$(awk -v revolutions="$(awk '$1 == "measure_revolutions" { print $3 }' "$here/cases/pilot_mill/case.toml")" \
  '$1 == revolutions { print $2 }' "$table")
scatter=$(awk -F, '/^[0-9]/ { n++; sum += $2; squares += $2 * $2 }
  END { mean = sum / n; half = 196 * sqrt((squares / n - mean * mean) * n / (n - 1)) / mean
    print half, half / sqrt(2 * (n - 1)) }' "$here/cases/pilot_mill/coverage/lives.csv")
gnuplot -e "table='$table'; picture='$picture'" - <<PLOT
set terminal pngcairo size 900,480 font "sans,12"
set output picture
set logscale xy
set key top right
set xlabel "particle steps of a campaign"
set ylabel "half the 95 % band of the life [%]"
set format x "%.0e"
set xrange [2e8:2e9]
set yrange [2:20]
set ytics (2, 5, 10, 20)
\$scatter << END
$usual $scatter
END
plot table using 2:4 with linespoints lw 2 pt 7 lc "#16365c" title "predicted, mean of two seeds", \\
     \$scatter using 1:2:3 with yerrorbars pt 6 ps 1.4 lw 2 lc "#a8431c" title "1.96 times the scatter of 16 seeds"
PLOT
