#!/bin/sh
# Does the mill that is sped up as its lifters wear wear them faster? The paper says its operators could
# raise the speed to 80 % of critical. The first load on a lifter of a campaign's results, worn to a
# given height, at the mill's own 74.4 % and at 80 %; and at the former with half the time step.
#   scripts/studies/worn_and_fast.sh DIR RESULTS HEIGHT_MM [VARIANT...]     RESULTS/history.csv, profiles.csv
set -eu
dir=$1 results=$2 height=$3; shift 3
. "$(dirname "$0")/first_load.sh"
mkdir -p "$dir"

# The first kept profile that is as low as that.
awk -F, -v height="$height" '
  FNR == NR { if (/^[0-9]/) above[$1, $2] = 1e3 * $5; next }
  FNR == 1 { print "# millwear profile 1\nxi_m,eta_m" }
  /^[0-9]/ && !found && above[$1, $2] <= height { found = 1; cycle = $1; step = $2 }
  found && $1 == cycle && $2 == step { print $5 "," $6 }
' "$results/history.csv" "$results/profiles.csv" >"$dir/worn_profile.csv"

settings() {
  profile=worn_profile.csv
  case $1 in
    worn) ;;
    worn_step15) rayleigh=0.15 ;;
    worn_fast) speed=12.26 ;;
  esac
}
[ $# -gt 0 ] || set -- worn worn_step15 worn_fast
study "$dir" "$@"
