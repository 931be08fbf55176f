#!/bin/sh
# Keeps a finished study's small files beside its study file: enough for `millwear study` to write the
# tables and the page anew.
#   scripts/keep_study.sh STUDY STUDY_FILE_FOLDER      writes STUDY_FILE_FOLDER/reference
set -eu
study=$1 kept=$2/reference
[ -s "$study/study.csv" ] || { echo "keep_study.sh: $study has no study.csv; finish it with millwear study" >&2; exit 1; }
rm -rf "$kept"
mkdir -p "$kept"
cp "$study/study.lock.toml" "$study/study.csv" "$kept"
# Where it ran, and by what command, is of that machine alone.
awk -F'\t' -v OFS='\t' 'NR > 1 { $2 = "-"; $6 = "-" } { print }' "$study/jobs.tsv" >"$kept/jobs.tsv"
for point in "$study"/points/*; do
  to=$kept/points/$(basename "$point")
  mkdir -p "$to/results"
  cp "$point/case.toml" "$point/ledger.jsonl" "$to"
  cp "$point/results/history.csv" "$point/results/profiles.csv" "$point/results/spectra.csv" \
    "$point/results/summary.json" "$to/results"
  for load in "$point"/cycle_*/dem; do
    cycle=$(basename "$(dirname "$load")")
    mkdir -p "$to/$cycle/dem"
    cp "$load/measured.json" "$to/$cycle/dem"
  done
done
