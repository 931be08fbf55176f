#!/bin/sh
#SBATCH --job-name={{name}}
#SBATCH --output={{log}}
#SBATCH --open-mode=append
#SBATCH --nodes=1
#SBATCH --ntasks=1
#SBATCH --cpus-per-task={{cores}}
#SBATCH --time={{time}}
#SBATCH --mem={{memory_mb}}M
#SBATCH --requeue
#SBATCH --signal=B:USR1@{{signal_seconds}}
{{options}}
set -u
{{setup}}
# Slurm's warning ends the work in order; it goes on in the next allocation of this job.
stopped=
{{command}} &
work=$!
trap 'stopped=yes; kill -TERM $work 2>/dev/null' USR1
wait $work
code=$?
while kill -0 $work 2>/dev/null; do
  wait $work
  code=$?
done
if [ -n "$stopped" ] && [ $code -gt 128 ]; then
  if [ "${SLURM_RESTART_COUNT:-0}" -lt {{most_restarts}} ]; then
    echo "millwear: stopped before the time was up; queued again (restart $((${SLURM_RESTART_COUNT:-0} + 1)) of {{most_restarts}})"
    scontrol requeue "$SLURM_JOB_ID"
    sleep 60
  else
    echo "millwear: stopped after {{most_restarts}} restarts; submit it again to go on"
  fi
fi
exit $code
