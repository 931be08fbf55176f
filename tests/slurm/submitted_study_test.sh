#!/bin/sh
# A study as an array of a real Slurm: one task reaches its walltime and is queued again, another is
# killed in the middle of its DEM, the same command submits what is missing, and the results are those
# of a study that ran here undisturbed.
#   submitted_study_test.sh PROGRAM CASE
set -eu
program=$1 case=$2
[ "$(id -u)" = 0 ] || { echo "only root can start a Slurm here"; exit 77; }
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
. "$here/slurm_here.sh"
trap 'stop_slurm; [ -n "${KEEP:-}" ] || rm -rf "$work"' EXIT
fail() { echo "$1"; tail -n 20 "$work"/study/slurm/*.log 2>/dev/null || true; exit 1; }
start_slurm "$work/slurm"

# Slurm's least walltime is a minute, and it warns up to half a minute before it has to. So a load should
# take some 30 s, that a campaign of several is not done by then, in chunks of 4 s, that it goes on however
# fast the machine is just now.
sed 's/^measure_revolutions.*/measure_revolutions = 4.0/' "$case" >"$work/probe.toml"
begin=$(date +%s%N)
"$program" run "$work/probe.toml" --out "$work/probe" --until 0:dem --quiet >/dev/null
taken=$(($(date +%s%N) - begin))
revolutions=$(awk -v taken=$taken 'BEGIN { printf "%.1f", 4.0 * 30e9 / taken }')
particle_steps=$(awk -v revolutions="$revolutions" -v steps="$("$program" check "$case" |
  awk '/steps a revolution/ { print $1 }')" 'BEGIN { printf "%.0f", 32 * steps * revolutions / 8 }')
sed "s/^measure_revolutions.*/measure_revolutions = $revolutions\nchunk_particle_steps = $particle_steps/" \
  "$case" >"$work/case.toml"
cat >"$work/study.toml" <<STUDY
format_version = 1
name = "submitted"
case = "case.toml"

[slurm]
partition = "all"
time = "00:01:00"
memory_gb = 0.5
signal_seconds = 10

[[axes]]
key = "mill.rows"
values = [6, 8]
STUDY
cd "$work"
"$program" study study.toml --slurm-dry-run >dry_run
grep -q '^#SBATCH --partition=all$' dry_run && grep -q 'to start at' dry_run || { cat dry_run; exit 1; }
"$program" study study.toml --most-points 5000 --slurm-dry-run | grep -q -- '--most-points 5000' ||
  fail "a task would refuse the points that the study was submitted with"
[ ! -e studies ] || fail "a dry run left a folder"
# What Slurm refuses is named, and nothing counts as submitted.
code=0
"$program" study study.toml --out refused --slurm --sbatch --partition=nowhere 2>message || code=$?
{ [ $code = 4 ] && grep -qi 'partition' message; } || fail "a partition that does not exist: exit code $code, $(cat message)"
"$program" status study.toml --out refused | grep -q '2 waiting' || fail "a refused campaign counts as submitted"
"$program" study study.toml --out local --jobs 2 --quiet >/dev/null &
local_study=$!
wait $local_study

"$program" study study.toml --out study --slurm
sleep 5
"$program" study study.toml --out study --slurm | grep -q 'nothing to submit' || fail "queued campaigns were submitted twice"
until ls study/points/*/cycle_000/.dem.partial >/dev/null 2>&1; do sleep 0.2; done
victim=$(squeue --noheader --array --states=RUNNING --format=%i --name=points_0 | head -1)
scancel --full -s KILL "$victim"
wait_for_jobs() {
  until [ -z "$(squeue --noheader)" ]; do sleep 2; done
}
wait_for_jobs
grep -q 'queued again' study/slurm/points_0_*.log || fail "no task reached its walltime and was queued again"
"$program" study study.toml --out study --slurm >/dev/null
wait_for_jobs
cmp local/study.csv study/study.csv || fail "the results differ"
