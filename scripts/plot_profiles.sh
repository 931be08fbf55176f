#!/bin/sh
# Draws a lifter from new to worn, as it stood when each load was measured, and at the end.
#   scripts/plot_profiles.sh RESULTS PICTURE.png      RESULTS/profiles.csv of a campaign
set -eu
results=$1 picture=$2
table=$(mktemp)
trap 'rm -f "$table"' EXIT

# The new profile and the last of each cycle, in millimetres, apart by blank lines.
awk -F, '
  /^[0-9]/ { key = $1 "," $2; if (key != last) { n++; cycle[n] = $1; hours[n] = $3; last = key }
    rows[n] = rows[n] 1e3 * $5 " " 1e3 * $6 "\n" }
  END { for (i = 1; i <= n; i++) if (i == 1 || i == n || cycle[i + 1] != cycle[i]) {
      m = split(rows[i], row, "\n")
      for (j = 1; j < m; j++) print row[j], hours[i]
      print "" } }' "$results/profiles.csv" >"$table"

gnuplot -e "table='$table'; picture='$picture'" - <<'PLOT'
set terminal pngcairo size 1000,560 font "sans,12"
set output picture
set size ratio -1
set xlabel "along the direction of rotation, mm"
set ylabel "above the new plate, mm"
set cblabel "operating hours"
set palette defined (0 "#2a4d8f", 0.5 "#8c8c8c", 1 "#c0392b")
unset key
plot table using 1:2:3 with lines lw 1.5 lc palette
PLOT
