#!/bin/sh
# What a DEM load buys: the error of the final profile against the number of loads, for both schemes
# on loads that are known in closed form. Prints the table and draws docs/schemes.png.
#   scripts/bench/schemes.sh
set -eu
cd "$(dirname "$0")/../.."
scripts/install_packages.sh test
cmake --preset ci >/dev/null
cmake --build --preset ci --target scheme_table >/dev/null
table=$(mktemp)
trap 'rm -f "$table"' EXIT
build/ci/tests/verification/wear/scheme_table | tee "$table"
gnuplot -e "table='$table'" - <<'PLOT'
set terminal pngcairo size 900,560 font "sans,12"
set output "docs/schemes.png"
set datafile separator ","
set logscale xy
set key top right
set xlabel "DEM loads in a campaign"
set ylabel "error of the final profile, share of the depth worn"
set format y "%g"
set yrange [0.0002:1]
set xrange [2:200]
set arrow from 2,0.01 to 200,0.01 nohead dashtype 2 linecolor "gray"
plot "< grep '^growing,threshold,' ".table using 3:4 with linespoints lw 2 pt 7 lc "#c44e52" title "rate grows with wear: threshold", \
     "< grep '^growing,adaptive,' ".table using 3:4 with linespoints lw 2 pt 5 lc "#4c72b0" title "rate grows with wear: adaptive", \
     "< grep '^slope,threshold,' ".table using 3:4 with linespoints lw 2 pt 6 dt 2 lc "#c44e52" title "rate set by slope: threshold", \
     "< grep '^slope,adaptive,' ".table using 3:4 with linespoints lw 2 pt 4 dt 2 lc "#4c72b0" title "rate set by slope: adaptive"
PLOT
