#!/bin/sh
# Campaigns of the pilot mill that differ in the seed of their packing alone, on one rank each, two at
# a time. Runs what is missing in FOLDER, so the same command resumes it, and prints how the predicted
# standard errors compare with the scatter. A campaign takes about eight minutes.
#   scripts/studies/coverage.sh FOLDER [SEED...]      by default seeds 1 to 16
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
millwear=${MILLWEAR:-$here/build/release/millwear}
table=${COVERAGE_TABLE:-$here/build/ci/tests/coverage/coverage_table}
folder=${1:?usage: coverage.sh FOLDER [SEED...]}
shift
[ $# -gt 0 ] || set -- 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16
mkdir -p "$folder"

for seed in "$@"; do
  awk -v seed="$seed" '/^name = / { print "name = \"pilot_mill_seed_" seed "\""; next }
    { print } /^\[dem\]/ { print "seed =", seed; print "ranks = 1" }
    ' "$here/cases/pilot_mill/case.toml" >"$folder/seed_$seed.toml"
done
printf '%s\n' "$@" | xargs -P 2 -I{} sh -c '"$1" run "$2/seed_$3.toml" --out "$2/seed_$3" --quiet \
  >"$2/seed_$3.log" 2>&1 || { echo "seed $3 failed; see $2/seed_$3.log" >&2; exit 1; }' run "$millwear" "$folder" {}

runs=""
for seed in "$@"; do runs="$runs $folder/seed_$seed"; done
# shellcheck disable=SC2086  # the list is meant to be split
"$table" "$folder/kept" $runs
