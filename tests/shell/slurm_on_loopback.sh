# Sourced by tests: a Slurm of this machine alone. Controller, one node and munge listen on 127.0.0.1 only, keep key,
# socket, state and logs in one folder, and end with stop_slurm; a Slurm that the machine may have is not touched.
#
#   start_slurm FOLDER     sets SLURM_CONF for sbatch and its kind; 1 if it does not come up (the reason is printed)
#   stop_slurm             call it in a trap; nothing runs afterwards, whether all had been started or not
#
# Needs root: a node starts jobs in the name of whoever asked for them.

slurm_pids=()

# Programs of the daemons are in folders that PATH of a user may lack.
slurm_program() {
  PATH=$PATH:/usr/sbin:/sbin command -v "$1"
}

# The first message on standard output says what is missing; nothing is missing: 0.
slurm_is_installed() {
  local program
  for program in munged slurmctld slurmd sbatch scontrol hostname; do
    slurm_program $program >/dev/null || { echo "$program is not installed"; return 1; }
  done
}

# A port of 127.0.0.1 on which nobody listens.
free_port() {
  local port
  while port=$((20000 + RANDOM % 12000)); (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null; do :; done
  echo $port
}

# within SECONDS COMMAND...: runs it until it succeeds.
within() {
  local end=$((SECONDS + $1))
  shift
  until "$@" >/dev/null 2>&1; do
    [[ $SECONDS -lt $end ]] || return 1
    sleep 0.1
  done
}

write_slurm_conf() {
  local folder=$1 controller=$2
  cat >"$folder/slurm.conf" <<CONF
ClusterName=loopback
SlurmctldHost=$controller(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MailProg=/bin/true
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,batch_sched_delay=1
SlurmdParameters=config_overrides
ReturnToService=2
NodeName=node NodeAddr=127.0.0.1 NodeHostname=$controller CPUs=2 State=UNKNOWN
PartitionName=night Nodes=node Default=YES State=UP
CONF
  # "disabled" is known from 24.05 on; before, version 1 touches no control group as long as no other plugin asks for one
  local plugin=disabled
  [[ ! $("$(slurm_program slurmd)" -V) =~ \ (1[0-9]|2[0-3])\. ]] || plugin=cgroup/v1
  echo "CgroupPlugin=$plugin" >"$folder/cgroup.conf"
}

node_is_idle() {
  [[ $(sinfo --noheader --format=%T --nodes=node) == idle ]]
}

all_are_running() {
  local pid
  for pid in "${slurm_pids[@]}"; do
    kill -0 "$pid" || return
  done
}

idle_or_ended() {
  ! all_are_running || node_is_idle
}

# It ends with the test, even where that is killed.
start_daemon() {
  setpriv --pdeathsig TERM "$(slurm_program "$1")" "${@:2}" >"${SLURM_CONF%/*}/$1.out" 2>&1 &
  slurm_pids+=($!)
}

start_slurm() {
  local folder=$1 controller
  controller=$(hostname -s)
  mkdir -p "$folder/state" "$folder/spool"
  chmod 755 "$folder"
  write_slurm_conf "$folder" "$controller"
  export SLURM_CONF=$folder/slurm.conf
  (umask 077 && head -c 1024 /dev/urandom >"$folder/munge.key")
  # --force: the folder of a test may be open to others, as /tmp is
  start_daemon munged --foreground --force --num-threads=2 --key-file="$folder/munge.key" \
    --socket="$folder/munge.socket" --pid-file="$folder/munged.pid" --log-file="$folder/munged.log" \
    --seed-file="$folder/munged.seed"
  within 10 test -S "$folder/munge.socket" || { tail -n 20 "$folder"/munged.{out,log}; return 1; }
  start_daemon slurmctld -D -f "$SLURM_CONF"
  start_daemon slurmd -D -N node -f "$SLURM_CONF"
  within 60 idle_or_ended && all_are_running 2>/dev/null || { sinfo; tail -n 20 "$folder"/slurm{ctld,d}.{out,log}; return 1; }
}

# Jobs first, then those that would look after them.
stop_slurm() {
  local pid
  [[ ${#slurm_pids[@]} -lt 3 ]] || timeout 20 scancel --user=root >/dev/null 2>&1 || true
  for pid in $(printf '%s\n' "${slurm_pids[@]}" | tac); do
    kill "$pid" 2>/dev/null || continue
    within 15 not_running "$pid" || kill -KILL "$pid" 2>/dev/null || true
    wait "$pid" 2>/dev/null || true
  done
  slurm_pids=()
}

not_running() {
  ! kill -0 "$1"
}
