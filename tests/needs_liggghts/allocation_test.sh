#!/bin/sh
# Starting ranks in places that give fewer slots than cores: an allocation of Slurm with one task of two
# cores (its variables set by hand), one processor of affinity, several copies by srun, and a launcher
# of one's own.
#   allocation_test.sh PROGRAM CASE
set -eu
program=$1 case=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$1"; exit 1; }
edit() { sed "$1" "$case" >"$work/$2"; }
edit 's/^ranks.*/ranks = 2/' two.toml
edit 's/^ranks.*/ranks = 0/' all.toml
edit 's|^ranks.*|ranks = 2\nlauncher = "mpirun -np {ranks} --oversubscribe --allow-run-as-root {command}"|' own.toml
edit 's|^ranks.*|ranks = 2\nlauncher = "mpirun -np 2 {command}"|' wrong.toml
cd "$work"
host=$(hostname)
allocation="SLURM_JOBID=7 SLURM_JOB_ID=7 SLURM_NODELIST=$host SLURM_JOB_NODELIST=$host SLURM_NNODES=1 \
  SLURM_JOB_NUM_NODES=1 SLURM_TASKS_PER_NODE=1 SLURM_NTASKS=1 SLURM_CPUS_PER_TASK=2 SLURM_CPUS_ON_NODE=2"

# Open MPI counts one slot here and refuses two ranks that do not ask for more.
if env $allocation mpirun --allow-run-as-root -np 2 true 2>/dev/null; then fail "the faked allocation has two slots"; fi
env $allocation "$program" run two.toml --out allocated --until 0:mix --quiet >/dev/null
"$program" run two.toml --out outside --until 0:mix --quiet >/dev/null
cmp allocated/cycle_000/mix/charge.restart outside/cycle_000/mix/charge.restart

# One processor is one rank, however many the machine has.
taskset -c "$(taskset -pc $$ | sed 's/.*: //; s/[-,].*//')" "$program" check all.toml | grep -q 'on 1 ranks' ||
  fail "ranks = 0 takes more ranks than it has processors"
env $allocation SLURM_CPUS_ON_NODE=1 "$program" check all.toml | grep -q 'on 1 ranks' || fail "ranks = 0 passes the allocation"

# Several copies would all work in one folder.
code=0
env $allocation SLURM_STEP_ID=0 SLURM_STEP_NUM_TASKS=2 "$program" run two.toml --out copies 2>refused || code=$?
[ $code = 2 ] && grep -q 'srun has started 2 copies' refused || { cat refused; exit 1; }
[ ! -e copies ] || fail "a copy left a folder"

# The campaign goes on with another launcher to the same results.
sed -n '/^\[dem\]/,/^\[/p' own.toml | grep -q launcher
"$program" run own.toml --out outside --until 0:dem --quiet >/dev/null
"$program" run two.toml --out allocated --until 0:dem --quiet >/dev/null
cmp allocated/cycle_000/dem/load.h5 outside/cycle_000/dem/load.h5
code=0
"$program" run wrong.toml --out wrong 2>refused || code=$?
[ $code = 3 ] && grep -q 'does not say {ranks}' refused || { cat refused; exit 1; }
[ ! -e wrong ] || fail "a launcher that starts nothing left a folder"
