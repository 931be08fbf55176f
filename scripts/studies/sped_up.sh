#!/bin/sh
# What does it change if the 8 m mill is sped up to 80 % of critical as its lifters wear, as the paper
# proposes? One life at constant speed and one that is sped up from 88 mm on, both cut at 63 mm. Prints
# the hours from there to Table 3's later heights, and draws PICTURE. Runs what is missing in FOLDER.
#   scripts/studies/sped_up.sh FOLDER PICTURE.png
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
millwear=${MILLWEAR:-$here/build/release/millwear}
folder=${1:?usage: sped_up.sh FOLDER PICTURE.png} picture=${2:?usage: sped_up.sh FOLDER PICTURE.png}
"$millwear" run "$here/cases/seed_mill_8m_desktop/coverage/case.toml" --ranks 2 --out "$folder/constant" --quiet >/dev/null
"$millwear" run "$here/cases/seed_mill_8m_sped_up/case.toml" --ranks 2 --out "$folder/sped_up" --quiet >/dev/null

# Hours at which a height is passed, with the standard error there as hours.
when() {
  awk -F, -v height="$2" '
    NR == 2 { for (i = 1; i <= NF; i++) column[$i] = i; next }
    /^[0-9]/ { hours = $column["operating_hours"]; high = 1e3 * $column["lifter_height_m"]
      error = 1e3 * $column["lifter_height_m_se"]; power = $column["power_w"] / 1e3
      if (seen && high <= height && before > height) {
        share = (before - height) / (before - high)
        print last + share * (hours - last), error * (hours - last) / (before - high), power; exit }
      seen = 1; last = hours; before = high }' "$1/results/history.csv"
}
printf '%-10s %12s %12s %12s %12s %12s %14s\n' mill "88 mm, h" "to 84, h" "to 56, h" "to 30, h" "to 20, h" "power at 30, kW"
for mill in constant sped_up; do
  start=$(when "$folder/$mill" 88 | cut -d' ' -f1)
  printf '%-10s %12.0f' "$mill" "$start"
  for height in 84 56 30 20.05; do
    when "$folder/$mill" $height | awk -v start="$start" '{ printf " %12s", sprintf("%.0f +- %.0f", $1 - start, $2) }'
  done
  when "$folder/$mill" 30 | awk '{ printf " %14.0f\n", $3 }'
done
gnuplot -e "folder='$folder'; picture='$picture'" - <<'PLOT'
set terminal pngcairo size 900,460 font "sans,12"
set output picture
set datafile separator ","
set xlabel "operating hours with k = 5e-12 1/Pa"
set ylabel "lifter height [mm]"
set yrange [0:220]
set grid
set arrow from graph 0, first 88 to graph 1, first 88 nohead dt 2 lc "#888888"
set label "sped up from here on" at graph 0.02, first 94 tc "#555555"
h = "operating_hours"; l = "lifter_height_m"; e = "lifter_height_m_se"
plot folder."/constant/results/history.csv" skip 1 using (column(h)):(1e3 * (column(l) - 2 * column(e))):(1e3 * (column(l) + 2 * column(e))) with filledcurves fs transparent solid 0.15 lc "#16365c" notitle, \
     folder."/sped_up/results/history.csv" skip 1 using (column(h)):(1e3 * (column(l) - 2 * column(e))):(1e3 * (column(l) + 2 * column(e))) with filledcurves fs transparent solid 0.15 lc "#a8431c" notitle, \
     folder."/constant/results/history.csv" skip 1 using (column(h)):(1e3 * column(l)) with lines lw 2 lc "#16365c" title "11.4 rpm throughout", \
     folder."/sped_up/results/history.csv" skip 1 using (column(h)):(1e3 * column(l)) with lines lw 2 lc "#a8431c" title "12.16 rpm, 80 % of critical, from 88 mm on"
PLOT
