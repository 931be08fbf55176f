#!/bin/sh
# Does the mill that is sped up as its lifters wear wear them faster? The paper says its operators could
# raise the speed to 80 % of critical. The first load on a lifter of a campaign's results, worn to a
# given height, at the mill's own 74.4 % and at 80 %; and at the former with half the time step.
#   scripts/studies/worn_and_fast.sh DIR RESULTS HEIGHT_MM [VARIANT...]     RESULTS/history.csv, profiles.csv
set -eu
dir=$1 results=$2 height=$3; shift 3
. "$(dirname "$0")/first_load.sh"
mkdir -p "$dir"
profile_at "$results" "$height" >"$dir/worn_profile.csv"

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
