#!/usr/bin/env bash
# A study on a Slurm of two virtual nodes on this machine, one of which dies in mid-run: its results
# must be those of a run without Slurm, none lost, none doubled.
#   two_nodes.sh PINEDA STUDY.toml
# Exit code 77 where Slurm is not installed or this is not root, who alone can start its daemons.
set -euo pipefail
pineda=$1 study=$2

for tool in slurmctld slurmd sbatch munged; do
  command -v "$tool" >/dev/null || { echo "Slurm is not installed: no $tool"; exit 77; }
done
[[ $EUID -eq 0 ]] || { echo "only root can start Slurm's daemons"; exit 77; }

folder=$(mktemp -d -t pineda-slurm-XXXXXX)
daemons=()
# What this Slurm's nodes have started, and no other's.
kill_steps() {
  local step
  for step in $(pgrep slurmstepd); do
    grep -q "SLURM_CONF=$folder/" "/proc/$step/environ" 2>/dev/null && kill -KILL "$step" 2>/dev/null
  done
  return 0
}
finish() {
  for daemon in "${daemons[@]}"; do
    { kill -KILL "$daemon" && wait "$daemon"; } 2>/dev/null || true
  done
  kill_steps
  rm -rf "$folder"
}
trap finish EXIT
fail() {
  echo "two_nodes: $*"
  tail -n 20 "$folder"/*.log "$folder"/*.slurm/*.log 2>/dev/null || true
  exit 1
}
free_port() {
  python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}

mkdir -p "$folder"/{state,spool1,spool2}
chmod 755 "$folder"
head -c 1024 /dev/urandom >"$folder/munge.key"
chmod 400 "$folder/munge.key"
munged --force --foreground --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
       --pid-file="$folder/munge.pid" --log-file="$folder/munge.log" --seed-file="$folder/munge.seed" \
       >/dev/null 2>&1 &
daemons+=($!)

host=$(hostname -s)
export SLURM_CONF=$folder/slurm.conf
cat >"$SLURM_CONF" <<CONF
ClusterName=virtual
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket,cred_expire=5
SlurmctldPort=$(free_port)
StateSaveLocation=$folder/state
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd%n.pid
SlurmdSpoolDir=$folder/spool%n
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd%n.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=1
SlurmdTimeout=10
KillWait=2
MinJobAge=300
SchedulerParameters=sched_interval=1,batch_sched_delay=0
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$(free_port) CPUs=1 State=UNKNOWN
NodeName=n2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$(free_port) CPUs=1 State=UNKNOWN
PartitionName=all Nodes=n1,n2 Default=YES MaxTime=10 State=UP
CONF
sed -i "s|spool%n|spool_%n|" "$SLURM_CONF"
mkdir -p "$folder"/spool_n{1,2}
until [[ -S $folder/munge.socket ]]; do sleep .1; done
slurmctld -D >/dev/null 2>&1 &
daemons+=($!)
slurmd -D -N n1 >/dev/null 2>&1 &
daemons+=($!)
slurmd -D -N n2 >/dev/null 2>&1 &
second=$!
daemons+=("$second")
for _ in {1..100}; do
  [[ $(sinfo --noheader --format=%D --states=idle 2>/dev/null | head -n 1) == 2 ]] && break
  sleep .2
done
[[ $(sinfo --noheader --format=%D --states=idle | head -n 1) == 2 ]] || fail "expected two idle nodes"

cd "$folder"
cp "$study" study.toml
"$pineda" study run study.toml --results whole.db --quiet

"$pineda" study run study.toml --results array.db --slurm 6 >array.log 2>&1 &
run=$!
# Once the second node has a task, it dies, with all that runs there.
for _ in {1..200}; do
  tasks=$(squeue --noheader --nodelist=n2 --states=running 2>/dev/null | wc -l)
  [[ $tasks -gt 0 ]] && break
  sleep .1
done
[[ $tasks -gt 0 ]] || fail "expected a task on the second node"
{ kill -KILL "$second" && wait "$second"; } 2>/dev/null || true
kill_steps
scontrol update nodename=n2 state=down reason=dead
wait "$run" || fail "the study on Slurm ended with $?"

"$pineda" study export whole.db --csv whole.csv --quiet
"$pineda" study export array.db --csv array.csv --quiet
cmp whole.csv array.csv || fail "results differ"
echo "$(($(wc -l <array.csv) - 1)) figures, those of a run without Slurm; one of two nodes died"
