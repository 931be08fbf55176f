#!/bin/sh
# Runs the unit tests' programs whole, two at a time: under the sanitizers a program takes longer to
# begin than most tests. Prints what a program that fails has to say.
#   scripts/run_sanitized_tests.sh FOLDER
set -eu
[ -x "$1/unit_mill" ] || { echo "$0: no tests are built in $1; run make sanitize" >&2; exit 2; }
find "$1" -maxdepth 1 -name 'unit_*' -type f -perm -u+x | sort -r |
  RC_PARAMS=seed=20060211 xargs -P 2 -I{} sh -c '"$1" --gtest_brief=1 >"$1.log" 2>&1 || { cat "$1.log"; exit 1; }
    echo "$(basename "$1"): $(grep PASSED "$1.log")"' run {}
