#!/bin/sh
# What it changes to compute less: the first load of the 8 m SAG mill, 40 % filled, with its sizes cut
# at 22 to 63 mm, with its largest rocks, with harder and softer contacts, with larger grains, with a
# wider slice, and with other dice. One rank each; power and hits are of 0.25 m of the mill.
#   scripts/studies/how_much_dem.sh DIR [VARIANT...]      runs what is missing in DIR, prints the table
# docs/how_much_dem.md has the result. cut22_soft takes hours, cut31_soft and cut45 half of one, the
# others minutes.
set -eu
all="base other_seed rocks stiff soft soft10 step15 soft_step15 wide grain14 cut45 cut45_soft cut31_soft cut22_soft"
. "$(dirname "$0")/first_load.sh"

settings() {
  case $1 in
    base) ;;
    other_seed) seed=2 ;;
    rocks) rocks=yes ;;
    stiff) steel=100 ;;
    soft) steel=1600 ore=400 ;;
    soft10) steel=4000 ore=1000 ;;
    step15) rayleigh=0.15 ;;
    soft_step15) steel=1600 ore=400 rayleigh=0.15 ;;
    wide) slice=0.5 ;;
    grain14) cut=0.045 grain=1.4 slice=0.35 ;;
    cut45) cut=0.045 ;;
    cut45_soft) cut=0.045 steel=1600 ore=400 ;;
    cut31_soft) cut=0.0315 steel=1600 ore=400 ;;
    cut22_soft) cut=0.022 steel=1600 ore=400 mix=0.7 measure=0.25 ;;
    *) echo "how_much_dem.sh: no variant $1; there are $all" >&2; exit 2 ;;
  esac
}

dir=$1; shift
[ $# -gt 0 ] || set -- $all
study "$dir" "$@"
