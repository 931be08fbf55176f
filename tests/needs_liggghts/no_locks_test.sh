#!/bin/sh
# A campaign on a file system without locks: a second one is refused and told who holds the folder, and
# what a killed one left is taken over at once.
#   no_locks_test.sh PROGRAM CASE LIBRARY_WITHOUT_LOCKS
set -eu
program=$1 case=$2
export LD_PRELOAD="$3"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$1"; exit 1; }
"$program" run "$case" --out "$work/run" --quiet >/dev/null 2>"$work/first" &
first=$!
until [ -e "$work/run/cycle_000/mesh" ]; do sleep 0.1; done
code=0
"$program" run "$case" --out "$work/run" --quiet 2>"$work/second" || code=$?
[ $code = 7 ] || fail "the second run ended with $code"
grep -q "in use by process [0-9]* on $(hostname)" "$work/second" || { cat "$work/second"; exit 1; }
kill -KILL $first
wait $first 2>/dev/null || true
[ -e "$work/run/.lock.lease" ] || fail "the killed run left no lease to be taken over"
"$program" run "$case" --out "$work/run" >/dev/null 2>"$work/told"
grep -q 'file system without locks' "$work/told" || { cat "$work/told"; exit 1; }
[ ! -e "$work/run/.lock.lease" ] || fail "a run that ended left its lease"
