#!/bin/sh
# Campaigns driven by make, one of them killed in the middle, are those of `millwear run`.
#   pipeline_test.sh PROGRAM CASE MAKEFILE
set -eu
program=$1 case=$2 makefile=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
sed 's/^name = "crash_mill"/name = "one"/; s/^ranks.*//' "$case" >one.toml
sed 's/^name = "crash_mill"/name = "two"/; s/^ranks.*//' "$case" >two.toml
pipeline() { make -s -f "$makefile" MILLWEAR="$program" OPTIONS="--quiet --ranks 1" "$@" >/dev/null; }
pipeline CASE=one.toml CYCLE=0 dem
[ -f runs/one/cycle_000/dem/load.h5 ] && [ ! -e runs/one/cycle_000/wear ]
setsid make -s -f "$makefile" MILLWEAR="$program" OPTIONS="--quiet --ranks 1" CASE=two.toml >/dev/null 2>&1 &
sleep 3
kill -KILL -- -$! 2>/dev/null || true
wait $! 2>/dev/null || true
sleep 1
pipeline CASES="one.toml two.toml" -j 2
for name in one two; do
  "$program" run $name.toml --ranks 1 --quiet --out alone_$name >/dev/null
  cmp alone_$name/results/history.csv runs/$name/results/history.csv
  [ -s runs/$name/report.html ]
done
