#!/bin/sh
# Keeps a finished campaign's small files beside its case, as the run that others are held against.
#   scripts/keep_reference.sh RUN CASE_FOLDER      writes CASE_FOLDER/reference/seed_SEED
set -eu
run=$1
[ -s "$run/results/summary.json" ] || { echo "keep_reference.sh: $run has no results/summary.json; finish it with millwear run" >&2; exit 1; }
value() {
  awk -F'"' -v key="$1" '$2 == key { print ($4 != "" ? $4 : $3); exit }' "$run/results/summary.json" | sed 's/^: //; s/,$//'
}
kept=$2/reference/seed_$(value seed)
rm -rf "$kept"
mkdir -p "$kept"
cp "$run/case.lock.toml" "$run/ledger.jsonl" "$run/results/history.csv" "$run/results/replicates.csv" \
  "$run/results/summary.json" "$run/results/history.png" "$run/results/profiles.png" "$kept"
# Of the profiles the new one and the last of each cycle.
awk -F, 'FNR == NR { if (/^[0-9]/) last[$1] = $2; next }
  !/^[0-9]/ || ($1 == 0 && $2 == 0) || $2 == last[$1]' "$run/results/profiles.csv" "$run/results/profiles.csv" >"$kept/profiles.csv"

{
  echo "# The run that is kept"
  echo
  echo "    millwear run cases/$(value case)/case.toml --seed $(value seed)"
  echo
  echo "| | |"
  echo "|---|---|"
  echo "| program | $(value millwear) |"
  echo "| DEM | $(value liggghts) |"
  echo "| ranks | $(value ranks) |"
  echo "| cycles | $(value cycles) |"
  echo "| ended by | $(value limit) |"
  echo "| wall time, all stages | $(sed -n 's/.*"wall_seconds":\([0-9.e+-]*\).*/\1/p' "$run/ledger.jsonl" |
    awk '{ s += $1 } END { printf "%d h %02d min", s / 3600, s % 3600 / 60 }') |"
  echo "| hash of the case | $(value case_hash) |"
  echo
  echo "\`ledger.jsonl\` has the wall time of every stage and a hash (XXH3, 128 bits) of every file it left;"
  echo "\`summary.json\` those of the results. \`profiles.csv\` is thinned: the new profile and the last of"
  echo "each cycle. Of the others:"
  echo
  echo "    $(cd "$kept" && sha256sum case.lock.toml history.csv replicates.csv | sed '2,$s/^/    /')"
} >"$kept/README.md"
