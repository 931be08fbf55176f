#!/bin/sh
# Campaigns of CASE that differ in the seed of their packing alone, on one rank each, two at a time. Runs what is
# missing in FOLDER, so the same command resumes it, and prints how the predicted standard errors compare with
# the scatter. A campaign of the pilot mill takes some four minutes, one of the 8 m mill cut at 63 mm half an hour.
#   scripts/studies/coverage.sh CASE FOLDER [SEED...]      by default seeds 1 to 16
#   scripts/studies/coverage.sh cases/pilot_mill/case.toml runs/coverage
#   scripts/studies/coverage.sh cases/seed_mill_8m_desktop/coverage/case.toml runs/coverage_8m 1 2 3 4
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
millwear=${MILLWEAR:-$here/build/release/millwear}
table=${COVERAGE_TABLE:-$here/build/ci/tests/coverage/coverage_table}
case=${1:?usage: coverage.sh CASE FOLDER [SEED...]} folder=${2:?usage: coverage.sh CASE FOLDER [SEED...]}
shift 2
[ $# -gt 0 ] || set -- 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16
mkdir -p "$folder"

printf '%s\n' "$@" | xargs -P 2 -I{} sh -c '"$1" run "$2" --seed "$4" --ranks 1 --out "$3/seed_$4" --quiet \
  >"$3/seed_$4.log" 2>&1 || { echo "seed $4 failed; see $3/seed_$4.log" >&2; exit 1; }' run "$millwear" "$case" "$folder" {}

runs=""
for seed in "$@"; do runs="$runs $folder/seed_$seed"; done
# shellcheck disable=SC2086  # the list is meant to be split
"$table" "$folder/kept" $runs
