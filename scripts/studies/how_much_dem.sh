#!/bin/sh
# What it changes to compute less: the first load of the 8 m SAG mill, 40 % filled, with its sizes cut
# at 22 to 63 mm, with its largest rocks, with harder and softer contacts, with larger grains, with a
# wider slice, and with other dice. One rank each; power and hits are of 0.25 m of the mill.
#   scripts/studies/how_much_dem.sh DIR [VARIANT...]      runs what is missing in DIR, prints the table
# The `early` ones are softened four times more and mixed for 0.4 revolutions only, so that the finest cut is
# a matter of an hour or two: to be held against each other.
# docs/how_much_dem.md has the result.
set -eu
all="base other_seed rocks stiff soft soft10 step15 soft_step15 cut45 early63 early63_wide early45 early45_grain14 early31 early22"
. "$(dirname "$0")/first_load.sh"

early() { cut=$1 measure=$2 steel=1600 ore=400 mix=0.4; }

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
    cut45) cut=0.045 ;;
    early63) early 0.063 0.3 ;;
    early63_wide) early 0.063 0.3; slice=0.5 ;;
    early45) early 0.045 0.3 ;;
    early45_grain14) early 0.045 0.3; grain=1.4 slice=0.35 ;;
    early31) early 0.0315 0.15 ;;
    early22) early 0.022 0.15 ;;
    *) echo "how_much_dem.sh: no variant $1; there are $all" >&2; exit 2 ;;
  esac
}

dir=$1; shift
[ $# -gt 0 ] || set -- $all
study "$dir" "$@"
