#!/bin/sh
# A campaign that begins with another's charge, with a lifter that is higher; what is refused; and a
# study whose points all begin with the charge of the base case.
#   carried_charge_test.sh PROGRAM CASE
set -eu
program=$1 case=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$1"; exit 1; }
edit() { sed "$1" "$case" >"$work/$2"; }
edit 's/^mix_revolutions.*/mix_revolutions = 3.0/' source.toml
carried='s|^mix_revolutions.*|mix_revolutions = 3.0\ncharge_from = "runs/source"|'
edit "$carried; s/^height_m.*/height_m = 0.035/; s/^count = 12/count = 14/" higher.toml
cd "$work"

# Refused before anything is written: no such campaign, and one of another mill.
if "$program" run higher.toml --out runs/higher 2>refused; then fail "a charge from nowhere was taken"; fi
grep -q 'runs/source, where no campaign has left a charge' refused || { cat refused; exit 1; }
[ ! -e runs/higher ] || fail "a refused campaign left a folder"
"$program" run source.toml --out runs/source --until 0:dem --quiet >/dev/null
edit "$carried; s/^slice_length_m.*/slice_length_m = 0.07/; s/^diameter_m = 0.025/diameter_m = 0.024/" other.toml
if "$program" run other.toml --out runs/other 2>refused; then fail "the charge of another mill was taken"; fi
grep -q "the slice's length (0.07 m, there 0.06), the charge (steel of 0.03 m, steel of 0.024 m, there" refused ||
  { cat refused; exit 1; }

# Taken: all that differs is told, it mixes until it is steady, and killed it goes on to the same.
"$program" check higher.toml >/dev/null
"$program" run higher.toml --out runs/higher --until 0:mix 2>told
grep -q 'cycle_000/dem/charge.restart: [1-9][0-9]* particles moved out of the steel, 2 added, 0 left' told ||
  { cat told; exit 1; }
grep -q 'mixed for .* revolutions' told || { cat told; exit 1; }
grep -q '^charge_from = "../source"$' runs/higher/case.lock.toml || fail "the locked path is not from its own folder"
"$program" run higher.toml --out runs/higher --until 0:dem --quiet >/dev/null
"$program" wear higher.toml --out runs/higher >/dev/null || fail "no law can be tried on its load"
"$program" run higher.toml --out runs/again --until 0:dem --quiet >/dev/null
cmp runs/higher/cycle_000/dem/load.h5 runs/again/cycle_000/dem/load.h5

# Moved together, they go on together.
mkdir elsewhere && mv runs higher.toml elsewhere
"$program" run elsewhere/higher.toml --out elsewhere/runs/higher --until 1:mesh --quiet >/dev/null

# A study mixes its base case once.
"$program" study source.toml --axis lifter.height_m=0.02,0.025 --charge-from-base --quiet --out study >/dev/null
[ -e study/charge/cycle_000/mix/charge.restart ] || fail "the base case was not mixed"
grep -q '^charge_from = "../../charge"$' study/points/0001-*/case.lock.toml || fail "a point does not begin with it"
mv study study_moved
lines=$(wc -l <study_moved/jobs.tsv)
"$program" study source.toml --axis lifter.height_m=0.02,0.025 --charge-from-base --quiet --out study_moved >/dev/null
[ "$(wc -l <study_moved/jobs.tsv)" = "$lines" ] || fail "a study that was moved ran its campaigns again"
if "$program" study source.toml --axis mill.slice_length_m=0.06,0.07 --charge-from-base --out none 2>refused; then
  fail "a point of another slice began with the base case's charge"
fi
grep -q "the slice's length (0.07 m, there 0.06)" refused || { cat refused; exit 1; }
[ ! -e none ] || fail "a refused study left a folder"
