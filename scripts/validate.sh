#!/bin/sh
# Simulates the published experiments of cases/validation, prints the tables of docs/validation.md and draws
# its pictures. A campaign that is finished in FOLDER is not run again; without FOLDER the figures that
# are kept beside the cases are taken as they are.
#   scripts/validate.sh [FOLDER]
set -eu
cd "$(dirname "$0")/.."
millwear=${MILLWEAR:-build/release/millwear}
tests=${TESTS:-build/ci/tests}
cases=cases/validation
table=$tests/validation/validation_table
impacts=$cases/oblique_impacts.csv

# The oblique impacts of the tests as a table, from the properties that they record.
kept_impacts() {
  "$tests/needs_liggghts/liggghts_sphere_on_wall" --gtest_filter='Kharaz*' --gtest_output="xml:$1/impacts.xml" >"$1/impacts.log" ||
    { cat "$1/impacts.log" >&2; exit 1; }
  echo "angle_deg,measured,simulated,sliding"
  awk -F'"' '/<property name=/ { value[$2] = $4 }
    /<\/properties>/ { print value["angle_deg"] "," value["measured"] "," value["simulated"] "," value["sliding"] }
  ' "$1/impacts.xml" | sort -n
}

if [ $# -gt 0 ]; then
  for folder in "$cases"/*/; do
    name=$(basename "$folder")
    "$millwear" run "$folder/case.toml" --ranks 2 --out "$1/$name"
    "$table" --keep "$folder" "$1/$name"
  done
  kept_impacts "$1" >"$1/impacts.csv"
  mv "$1/impacts.csv" "$impacts"
fi

"$table" "$cases"/*/
echo
echo "| angle from the normal | measured | simulated | fully sliding |"
echo "|---|---|---|---|"
awk -F, 'NR > 1 { printf "| %.1f° | %.3f | %.3f | %s |\n", $1, $2, $3, $1 < 15 ? "-" : sprintf("%.3f", $4) }' "$impacts"

# Place, ratio of simulated to published and the standard error of it, and a name.
ratios=$(mktemp)
trap 'rm -f "$ratios"' EXIT
"$table" "$cases"/*/ | awk -F'|' '
  function figure(text) { split(text, part, "±"); value = part[1] + 0; error = part[2] / value }
  NR > 2 { figure($4); published = value; e = error; figure($5)
    gsub(/^ | $/, "", $2); gsub(/_/, " ", $2); sub(/,.*/, "", $3)
    ratio = value / published
    printf "%d|%g|%g|%s,%s\n", NR - 2, ratio, ratio * sqrt(e ^ 2 + error ^ 2), $2, $3 }' >"$ratios"
gnuplot -e "ratios='$ratios'; impacts='$impacts'" - <<'PLOT'
set terminal pngcairo size 900,360 font "sans,12"
set output "docs/validation.png"
set datafile separator "|"
set xlabel "simulated / published, with one standard error of both"
set yrange [*:*] reverse
set offsets 0, 0, 0.5, 0.5
set xrange [0.6:1.2]
set arrow from 1, graph 0 to 1, graph 1 nohead lc "#888888"
unset key
set grid xtics
plot ratios using 2:1:3:ytic(4) with xerrorbars pt 7 ps 1.4 lw 2 lc "#16365c"
reset
set terminal pngcairo size 900,420 font "sans,12"
set output "docs/oblique_impacts.png"
set datafile separator ","
set xlabel "angle from the normal [degrees]"
set ylabel "tangential speed after / before"
set xrange [0:65]
set yrange [0.4:1.05]
set key bottom right
plot impacts using 1:2 skip 1 with points pt 7 ps 1.5 lc "#a8431c" title "measured (Kharaz et al. 2001)", \
     impacts using 1:3 skip 1 with points pt 4 ps 1.8 lw 2 lc "#16365c" title "simulated", \
     impacts using ($1 > 15 ? $1 : NaN):4 skip 1 with lines lw 2 lc "#888888" title "sliding through all of the impact"
PLOT
