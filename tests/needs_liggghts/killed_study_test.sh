#!/bin/sh
# A study that is killed three times in the middle ends in the study.csv of one that is not.
#   killed_study_test.sh PROGRAM CASE
set -eu
program=$1 case=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
set -- study "$case" --axis mill.rows=6,8 --axis dem.seed=1,2 --objective "maximise life_hours" --quiet --out
"$program" "$@" "$work/whole" >/dev/null
for seconds in 2 4 6; do
  "$program" "$@" "$work/killed" >/dev/null 2>&1 &
  sleep $seconds
  kill -KILL $! 2>/dev/null || true
  wait $! 2>/dev/null || true
done
"$program" "$@" "$work/killed" >/dev/null
cmp "$work/whole/study.csv" "$work/killed/study.csv"
"$program" status "$case" --out "$work/killed" | grep -q ': 4 campaigns, 4 done$'

# Another axis runs no campaign again that it has.
before=$(wc -l <"$work/whole/jobs.tsv")
"$program" "$@" "$work/whole" >/dev/null
"$program" study "$case" --axis mill.rows=6 --axis dem.seed=1,2 --quiet --out "$work/whole" >/dev/null
[ "$(wc -l <"$work/whole/jobs.tsv")" = "$before" ] || { echo "campaigns were run again"; exit 1; }

# Points that differ in the coefficient alone take each other's DEM: the results are those of a
# campaign by itself.
"$program" study "$case" --axis wear.specific_wear_rate_per_pa=1e-12,2e-12 --jobs 1 --quiet --out "$work/shared" >/dev/null
point=$(ls -d "$work"/shared/points/0002-*)
"$program" run "$point/case.toml" --ranks 1 --quiet --out "$work/alone" >/dev/null
cmp "$work/alone/results/history.csv" "$point/results/history.csv"
dem=$(ls -d "$work"/shared/shared/*/ | wc -l)
cycles=$(ls -d "$point"/cycle_* | wc -l)
[ "$dem" = $((cycles + 1)) ] || { echo "$dem stages of DEM for $cycles cycles"; exit 1; }
