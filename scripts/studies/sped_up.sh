#!/bin/sh
# How much sooner is the lifter worn out if the mill is sped up, from the height on at which the paper
# calibrates (88 mm)? The rest of a campaign's life at the mill's own 74.4 % of critical, and at the 80 %
# that the paper says its operators could go to. Prints the hours from there to Table 3's later heights.
#   scripts/studies/sped_up.sh DIR RESULTS HEIGHT_MM [VARIANT...]     RESULTS/history.csv, profiles.csv
set -eu
dir=$1 results=$2 height=$3; shift 3
. "$(dirname "$0")/first_load.sh"
mkdir -p "$dir"
profile_at "$results" "$height" >"$dir/from_profile.csv"

settings() {
  profile=from_profile.csv cycles=60 measure=0.25
  case $1 in
    as_before) ;;
    sped_up) speed=12.26 ;;
  esac
}
[ $# -gt 0 ] || set -- as_before sped_up
run_missing "$dir" "$@"
printf '%-12s %6s %12s %12s %12s\n' variant loads "to 84 mm, h" "to 56 mm, h" "to 30 mm, h"
for variant in "$@"; do
  awk -F, -v variant="$variant" '
    NR == 2 { for (i = 1; i <= NF; i++) at[$i] = i }
    /^[0-9]/ { n++; hours[n] = $at["operating_hours"]; high[n] = 1e3 * $at["lifter_height_m"]; loads = $at["cycle"] + 1 }
    function when(height,   i) {
      for (i = 2; i <= n; i++) if (high[i] <= height && high[i-1] > height)
        return sprintf("%.0f", hours[i-1] + (hours[i] - hours[i-1]) * (high[i-1] - height) / (high[i-1] - high[i]))
      return "-"
    }
    END { printf "%-12s %6d %12s %12s %12s\n", variant, loads, when(84), when(56), when(30) }
  ' "$dir/$variant/results/history.csv"
done
