#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A Slurm cluster of this machine alone, without systemd: for trying a sweep, and for tests. As root;
# Debian packages slurmctld, slurmd, slurm-client, munge.
#
# usage: one-machine.sh start FOLDER     writes FOLDER/slurm.conf and starts it
#        one-machine.sh slurmd FOLDER    starts slurmd again, after it was ended
#        one-machine.sh stop FOLDER
#
# For the commands of Slurm: export SLURM_CONF=FOLDER/slurm.conf
set -eu
verb=$1
mkdir -p "$2"
folder=$(cd "$2" && pwd)  # slurmctld changes its folder: the name must be absolute
host=$(hostname -s)
export SLURM_CONF="$folder/slurm.conf"

write_conf() {
  mkdir -p "$folder/state" "$folder/spool" "$folder/log"
  cat > "$SLURM_CONF" <<END
ClusterName=kinextest
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/log/ctld.log
SlurmdLogFile=$folder/log/d.log
SlurmctldPort=16817
SlurmdPort=16818
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
ReturnToService=2
SlurmdTimeout=20
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=2000 State=UNKNOWN
PartitionName=test Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
}

start_munge() {
  if munge -n > /dev/null 2>&1; then return; fi
  mkdir -p /run/munge
  chown munge:munge /run/munge
  runuser -u munge -- munged
  touch "$folder/munged-is-ours"
}

# Until the node takes jobs.
wait_for_node() {
  for _ in $(seq 60); do
    case $(sinfo --noheader -o %T 2> /dev/null) in
      idle | mixed | allocated) return ;;
    esac
    sleep 0.5
  done
  echo "one-machine.sh: the node does not come up: see $folder/log" >&2
  exit 1
}

case $verb in
  start)
    write_conf
    start_munge
    slurmctld -f "$SLURM_CONF"
    slurmd -f "$SLURM_CONF"
    wait_for_node
    ;;
  slurmd)
    slurmd -f "$SLURM_CONF"
    wait_for_node
    ;;
  stop)
    scontrol shutdown || true
    for _ in $(seq 40); do
      [ -e "$folder/slurmctld.pid" ] || [ -e "$folder/slurmd.pid" ] || break
      sleep 0.25
    done
    if [ -e "$folder/munged-is-ours" ]; then
      kill "$(cat /run/munge/munged.pid)"
      rm "$folder/munged-is-ours"
    fi
    ;;
  *)
    echo "usage: one-machine.sh start|slurmd|stop FOLDER" >&2
    exit 2
    ;;
esac
