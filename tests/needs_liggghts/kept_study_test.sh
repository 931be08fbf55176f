#!/bin/sh
# The kept study of the 8 m mill's spacing is whole: its tables are gathered anew from its points, without
# any DEM, and are those that are kept.
#   kept_study_test.sh PROGRAM STUDY_FOLDER
set -eu
program=$1 study=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$study/reference" "$work/kept"
rm "$work/kept/study.csv"
"$program" study "$study/study.toml" --out "$work/kept" --gather --quiet
cmp "$work/kept/study.csv" "$study/reference/study.csv" || { echo "another study.csv"; exit 1; }
awk -F, '/^point/ { for (i = 1; i <= NF; i++) column[$i] = i; next }
  /^[0-9]/ { if ($column["done"] != $column["replicates"]) { print "point", $1, "is not done"; exit 1 } }
  ' "$work/kept/study.csv"
