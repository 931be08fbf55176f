# Starts a Slurm of one node on this machine, for a test that sources this file; as root, without
# munge. Everything lies in the folder given.
#   start_slurm FOLDER; stop_slurm

start_slurm() {
  slurm=$1
  mkdir -p "$slurm/state" "$slurm/spool"
  host=$(hostname)
  cat >"$slurm/slurm.conf" <<CONF
ClusterName=here
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/none
# A job that is queued again waits until its credential has expired, 120 s by default.
AuthInfo=cred_expire=5
CredType=cred/none
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
ReturnToService=2
KillWait=5
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=5,bf_interval=5
SlurmctldPidFile=$slurm/slurmctld.pid
SlurmdPidFile=$slurm/slurmd.pid
StateSaveLocation=$slurm/state
SlurmdSpoolDir=$slurm/spool
SlurmctldLogFile=$slurm/slurmctld.log
SlurmdLogFile=$slurm/slurmd.log
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 RealMemory=2000
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
  export SLURM_CONF="$slurm/slurm.conf"
  slurmctld -c && slurmd || return 1
  tries=0
  until sinfo --noheader --format=%t 2>/dev/null | grep -q idle; do
    tries=$((tries + 1))
    [ $tries -lt 100 ] || { echo "Slurm does not come up:"; tail -5 "$slurm"/*.log; return 1; }
    sleep 0.2
  done
}

# Returns when both daemons have ended: until then they write their state into the folder.
stop_slurm() {
  for daemon in slurmd slurmctld; do
    [ -s "$slurm/$daemon.pid" ] || continue
    process=$(cat "$slurm/$daemon.pid")
    kill "$process" 2>/dev/null || continue
    tries=0
    while kill -0 "$process" 2>/dev/null; do
      tries=$((tries + 1))
      [ $tries -lt 300 ] || { kill -KILL "$process" 2>/dev/null || true; break; }
      sleep 0.1
    done
  done
}
