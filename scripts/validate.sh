#!/bin/sh
# Simulates the published experiments of cases/validation and prints the table of docs/validation.md.
# A campaign that is finished in FOLDER is not run again; without FOLDER the figures that are kept
# beside the cases are taken as they are.
#   scripts/validate.sh [FOLDER]
set -eu
cd "$(dirname "$0")/.."
millwear=${MILLWEAR:-build/release/millwear}
table=${VALIDATION_TABLE:-build/ci/tests/validation/validation_table}
if [ $# -gt 0 ]; then
  for folder in cases/validation/*/; do
    name=$(basename "$folder")
    "$millwear" run "$folder/case.toml" --ranks 2 --out "$1/$name"
    "$table" --keep "$folder" "$1/$name"
  done
fi
"$table" cases/validation/*/
