#!/bin/sh
# A campaign whose stretches are cut into chunks: killed in the second chunk, it keeps the first and ends
# with the same as one that was not disturbed; a measurement that goes on does so by chunks.
#   chunks_test.sh PROGRAM CASE
set -eu
program=$1 case=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$1"; exit 1; }
sed 's/^measure_revolutions.*/measure_revolutions = 8.0\nchunk_particle_steps = 1e6/' "$case" >"$work/case.toml"
cd "$work"
"$program" run case.toml --out undisturbed --until 0:dem --quiet >/dev/null
[ -e undisturbed/cycle_000/dem/liggghts_1.log ] || fail "the measurement was not cut into chunks"
[ "$(find undisturbed -name '.*chunk*' | wc -l)" = 0 ] || fail "chunks were left behind a finished stage"

"$program" run case.toml --out killed --until 0:dem --quiet >/dev/null 2>&1 &
campaign=$!
until [ -e killed/cycle_000/.dem.chunk_0 ]; do
  kill -0 $campaign 2>/dev/null || fail "the campaign ended before it could be killed"
  sleep 0.05
done
kill -KILL $campaign
wait $campaign 2>/dev/null || true
first=$(ls -i killed/cycle_000/.dem.chunk_0/charge.restart | cut -d' ' -f1)
"$program" run case.toml --out killed --until 0:dem --quiet >/dev/null &
campaign=$!
until [ -e killed/cycle_000/.dem.chunk_1.partial/liggghts.log ]; do
  kill -0 $campaign 2>/dev/null || fail "the campaign did not go on with its second chunk"
  sleep 0.02
done
again=$(ls -i killed/cycle_000/.dem.chunk_0/charge.restart | cut -d' ' -f1)
[ "$first" = "$again" ] || fail "the first chunk was simulated again"
wait $campaign
for file in load.h5 torque.txt charge.restart events.h5; do
  [ ! -e undisturbed/cycle_000/dem/$file ] || cmp undisturbed/cycle_000/dem/$file killed/cycle_000/dem/$file
done

"$program" run case.toml --out on_scratch --scratch "$work/scratch" --until 0:dem --quiet >/dev/null
cmp undisturbed/cycle_000/dem/load.h5 on_scratch/cycle_000/dem/load.h5
[ -z "$(ls -A scratch)" ] || fail "something was left on the scratch disk"

sed 's/^measure_revolutions.*/measure_revolutions = 2.0\ntarget_relative_error = 0.02\nmost_revolutions = 4.0\nchunk_particle_steps = 2e5/; s/^time_blocks.*/time_blocks = 6/' \
  "$case" >going_on.toml
"$program" run going_on.toml --out going_on --until 0:dem --quiet >/dev/null
grep -q '"revolutions": 4.0' going_on/cycle_000/dem/measured.json || fail "the measurement did not go on to its most"
grep -q '"target_relative_error": 0.02' going_on/cycle_000/dem/measured.json || fail "its target is lost"
