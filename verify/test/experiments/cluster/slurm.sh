#!/bin/bash
# slurm.sh PROGRAM SOURCE: experiments/cluster on a Slurm of two nodes that are this machine: a task is killed and queued again, and the merged
# tables are those of the serial campaign. Exit status 77 where Slurm cannot be started. Leaves no process and no file.

set -u
program=$1 cluster=$2/experiments/cluster
skip() { echo "skipped: $*"; exit 77; }
((EUID == 0)) || skip "a Slurm of one's own is started as root"
for tool in munged slurmctld slurmd sbatch squeue scontrol scancel; do
  command -v $tool > /dev/null || skip "no $tool; expected the packages slurm-wlm and munge"
done

work=$(mktemp -d /tmp/tetracone_slurm.XXXXXX) daemons=()
chmod 755 "$work"
finish()
{
  scancel --full --signal=KILL --user=root 2> /dev/null
  for ((k = 0; k < 50; ++k)); do [[ -n $(squeue -h -t R,CG 2> /dev/null) ]] || break; sleep 0.1; done
  ((${#daemons[@]} == 0)) || { kill "${daemons[@]}"; wait "${daemons[@]}"; } 2> /dev/null
  rm -rf "$work"
  ! pgrep -af "$work" || { echo "FAILED: these were left behind"; exit 1; }
}
trap finish EXIT
fail() { echo "FAILED: $*"; tail -qn 3 "$work"/*.log "$work"/task-* "$work"/merge.out 2> /dev/null; exit 1; }
# until_true SECONDS WORDS...
until_true() { local end=$((SECONDS + $1)); shift; until "$@" > /dev/null 2>&1; do ((SECONDS < end)) || return 1; sleep 0.2; done; }

# Daemons of our own, on ports and with a key of their own.
port=$((20000 + RANDOM % 20000))
dd if=/dev/urandom of="$work/munge.key" bs=256 count=1 status=none
chmod 400 "$work/munge.key"
mkdir "$work/state" "$work/disk"
host=$(hostname -s)
cat > "$work/slurm.conf" << END
ClusterName=tetracone_test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
AuthInfo=socket=$work/munge.socket
SlurmUser=root
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
ReturnToService=2
KillWait=2
SchedulerParameters=bf_interval=1,sched_min_interval=100000
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool.%n
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.%n.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.%n.log
NodeName=one NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=1
NodeName=two NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=1
PartitionName=all Nodes=ALL Default=YES State=UP
END
export SLURM_CONF=$work/slurm.conf
munged --force --foreground --key-file="$work/munge.key" --socket="$work/munge.socket" --pid-file="$work/munged.pid" \
  --log-file="$work/munged.log" --seed-file="$work/munge.seed" > "$work/start.log" 2>&1 &
daemons+=($!)
until_true 10 test -S "$work/munge.socket" || skip "munged does not start: $(tail -n 1 "$work/start.log")"
slurmctld -D -i > "$work/start.log" 2>&1 &
daemons+=($!)
for node in one two; do slurmd -D -N $node > "$work/start.$node.log" 2>&1 & daemons+=($!); done
idle() { [[ $(sinfo -h -t idle -o %D) == 2 ]]; }
until_true 20 idle || skip "Slurm does not start: $(tail -qn 1 "$work"/slurm*.log | head -c 300)"

# A subject that needs its time on any machine.
cat > "$work/slow" << 'END'
while IFS= read -r line; do
  case $line in '{"ask":'*) sleep 0.12; line=${line#'{"ask":'}; echo "{\"ask\":${line%%,*},\"answer\":0}" ;; esac
done
END
words=(--cases 20 --level object --frames 0 --subject slow --subject-command "slow=sh $work/slow")
for family in random stacked sliver vertex-on-face; do words+=(--family $family); done
out=$work/out
export TETRACONE=$program TETRACONE_KEEP=1 TETRACONE_LOCAL=$work/disk
job=$(sbatch --parsable --array=0-3 --output="$work/task-%a" "$cluster/campaign.sbatch" 4 "$out" "${words[@]}") || fail "sbatch"

# One is killed once something of it is kept, and while it runs.
running() { [[ -n $(squeue -h -t R -j "${job}_1") ]]; }
begun() { "$program" report --progress "$out/shard-1-of-4.db" | grep -q 'shard 1 of 4, [1-9]'; }
until_true 40 begun || fail "nothing of shard 1 was kept"
running || fail "shard 1 was over before it could be killed"
scancel --full --signal=KILL "${job}_1"
over() { ! running; }
until_true 20 over || fail "shard 1 was not killed"
"$program" report --progress "$out/shard-1-of-4.db" && fail "shard 1 was done when it was killed"
until_true 20 scontrol requeue "${job}_1" || fail "shard 1 was not queued again"
start_now() { running || { scontrol update JobId="${job}_1" StartTime=now; false; }; }
until_true 20 start_now || fail "shard 1 is held back: $(scontrol update JobId="${job}_1" StartTime=now 2>&1; squeue -o "%i %T %r %S")"  # Slurm waits two minutes
merge=$(sbatch --parsable --dependency="afterany:$job" --output="$work/merge.out" "$cluster/merge.sbatch" "$out") || fail "sbatch of the merge"

"$program" verify --db "$work/serial.db" "${words[@]}" > "$work/serial.log" 2>&1 || fail "the serial campaign"
merged() { [[ $(scontrol show job "$merge") == *JobState=COMPLETED* ]]; }
until_true 25 merged || fail "no merged table: $(squeue -o "%i %T %r %S"; scontrol show job "${job}_1" | grep -E "State|Time")"
tables() { for table in errors subjects distance relations truth wrong commands runs; do "$program" report "$1" --table $table || fail "table $table of $1"; done; }
diff <(tables "$work/serial.db") <(tables "$out/campaign.db") || fail "the merged tables are not the serial ones"
(($("$program" report "$out/campaign.db" --table errors | grep -c ,slow,) == 8)) || fail "the table of errors is not whole"
(($(ls "$work/disk" | wc -l) <= 1)) || fail "left on the node's disk, besides what the killed task could not remove: $(ls "$work/disk")"
echo "two nodes, four shards, one killed and queued again: the serial tables, after $SECONDS s"
