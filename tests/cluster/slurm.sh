#!/usr/bin/env bash
# The recipes of docs/cluster.md on a real Slurm of one node, and with GNU parallel: a search in shards, one task killed and
# requeued, all merged, and compared byte by byte with the same search in one process.
#
# Needs root and Debian's packages slurm-wlm, munge and parallel, which it installs if they are missing. Everything that it writes is in
# a temporary folder; every process that it starts is ended. Takes about a minute, and gives up after DEADLINE seconds.
#
# usage: tests/cluster/slurm.sh [PATH OF knotproof]
set -uo pipefail
DEADLINE=${DEADLINE:-150}
repository=$(cd "$(dirname "$0")/../.." && pwd)
program=${1:-$repository/target/release/knotproof}
passed=0 failed=0
started=$SECONDS

say() { printf '%s\n' "$*"; }
check() { # check NAME COMMAND…: counts whether the command succeeds.
    local name=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
        say "ok      $name"
    else
        failed=$((failed + 1))
        say "FAILED  $name"
    fi
}
finish() {
    say "$passed passed, $failed failed"
    [ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
    exit
}
give_up() {
    failed=$((failed + 1))
    say "FAILED  $*"
    finish
}
# wait_for WHAT SECONDS COMMAND…: until the command succeeds.
wait_for() {
    local what=$1 until=$((SECONDS + $2))
    shift 2
    until "$@"; do
        [ "$SECONDS" -lt "$until" ] && [ $((SECONDS - started)) -lt "$DEADLINE" ] || give_up "no $what in time"
        sleep 0.2
    done
}

[ -x "$program" ] || give_up "there is no program $program: run cargo build --release"
missing=()
for pair in slurmctld:slurm-wlm munged:munge parallel:parallel; do
    command -v "${pair%%:*}" > /dev/null || missing+=("${pair##*:}")
done
if [ ${#missing[@]} -gt 0 ]; then
    say "installing ${missing[*]}"
    { apt-get update -q && DEBIAN_FRONTEND=noninteractive \
        apt-get install -q -y --no-install-recommends "${missing[@]}"; } > /dev/null 2>&1 ||
        give_up "cannot install ${missing[*]}"
fi

work=$(mktemp -d)
daemons=()
clean_up() {
    for pid in "${daemons[@]}"; do kill "$pid" 2> /dev/null; done
    for pid in "${daemons[@]}"; do
        for _ in $(seq 50); do
            kill -0 "$pid" 2> /dev/null || continue 2
            sleep 0.1
        done
        kill -9 "$pid" 2> /dev/null
    done
    rm -rf "$work"
}
trap clean_up EXIT
trap 'exit 1' INT TERM
mkdir -p "$work"/{bin,etc,state,spool,run,log,slurm,parallel}
chmod 755 "$work"
ln -s "$program" "$work/bin/knotproof"
export PATH="$work/bin:/usr/sbin:$PATH"

# A search that takes one process some seconds, whatever the machine.
count=2000
while :; do
    export SEARCH="--degree 6 --count $count --seed 1" SHARDS=8
    begin=$(date +%s%N)
    # shellcheck disable=SC2086 # SEARCH is several words.
    knotproof search $SEARCH --threads 1 --format json > "$work/whole.jsonl"
    code=$?
    took=$((($(date +%s%N) - begin) / 1000000))
    [ "$code" -le 1 ] || give_up "the search itself: exit code $code"
    [ "$took" -lt 8000 ] && [ "$count" -lt 1000000000 ] || break
    count=$((count * (took < 800 ? 10 : 2)))
done
say "search $SEARCH: $took ms in one process, $(($(wc -l < "$work/whole.jsonl") - 1)) findings"

# The recipes, as they are printed.
block() { # block NUMBER: that marked block of the documentation.
    awk -v wanted="$1" '/^<!-- the next block is run by/ { number++ }
        /^```$/ { inside = 0 }
        inside && number == wanted { print }
        /^```sh$/ { inside = !done[number]; done[number] = 1 }' "$repository/docs/cluster.md"
}
block 1 > "$work/slurm/shard.slurm"
block 2 > "$work/parallel/recipe.sh"
grep -q SLURM_ARRAY_TASK_ID "$work/slurm/shard.slurm" || give_up "docs/cluster.md has no recipe for Slurm"
grep -q joblog "$work/parallel/recipe.sh" || give_up "docs/cluster.md has no recipe for GNU parallel"

# A Slurm of one node on the loopback.
host=$(hostname -s)
port=$((20000 + RANDOM % 20000))
dd if=/dev/urandom of="$work/etc/munge.key" bs=1 count=1024 2> /dev/null
chmod 400 "$work/etc/munge.key"
chmod 700 "$work/etc" "$work/log"
munged --force --key-file="$work/etc/munge.key" --socket="$work/run/munge.socket" --pid-file="$work/run/munged.pid" \
    --log-file="$work/log/munged.log" --seed-file="$work/etc/munge.seed" > "$work/log/munged.out" 2>&1 ||
    give_up "munged: $(cat "$work/log/munged.out")"
daemons+=("$(cat "$work/run/munged.pid")")
cat > "$work/etc/slurm.conf" << CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$work/run/munge.socket,cred_expire=5
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/run/slurmctld.pid
SlurmdPidFile=$work/run/slurmd.pid
SlurmctldLogFile=$work/log/slurmctld.log
SlurmdLogFile=$work/log/slurmd.log
JobCompType=jobcomp/filetxt
JobCompLoc=$work/log/jobs
MinJobAge=3600
ReturnToService=2
SchedulerParameters=sched_interval=1
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=test Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF="$work/etc/slurm.conf"
slurmctld -D -i -c > "$work/log/slurmctld.out" 2>&1 &
daemons=("$!" "${daemons[@]}")
slurmd -D -N "$host" > "$work/log/slurmd.out" 2>&1 &
daemons=("$!" "${daemons[@]}")
node_is_up() { [ "$(sinfo -h -o %T 2> /dev/null)" = idle ]; }
wait_for "idle node" 40 node_is_up
say "Slurm $(sinfo -V | cut -d' ' -f2): one node, $(nproc) cores"

# Two arrays of four, the second with an offset.
cd "$work/slurm" || exit 1
jobs=()
for OFFSET in 0 4; do
    export OFFSET
    jobs+=("$(sbatch --parsable --array=0-3 --output=task-%A-%a.log shard.slurm)")
done
say "sbatch: arrays ${jobs[*]}"

# Shard 1 is killed as soon as it has a state, and its whole task with it.
state_of() { scontrol show job "$1" 2> /dev/null | grep -o 'JobState=[A-Z_]*' | head -n 1 | cut -d= -f2; }
is_in() { case " $2 " in *" $(state_of "$1") "*) true ;; *) false ;; esac; }
victim=${jobs[0]}_1
process_of() { pgrep -x knotproof | while read -r pid; do
    tr '\0' ' ' < "/proc/$pid/cmdline" 2> /dev/null | grep -q -- "--shard 1/$SHARDS --checkpoint shard-1.jsonl" &&
        [ "$(readlink "/proc/$pid/cwd")" = "$work/slurm" ] && echo "$pid"
done; }
has_started() { [ -s shard-1.jsonl ] && [ -n "$(process_of)" ]; }
wait_for "process of shard 1" 40 has_started
kill -9 "$(process_of | head -n 1)"
say "killed the process of task $victim"
wait_for "end of the killed task" 30 is_in "$victim" "FAILED CANCELLED"
check "the killed task counts as failed" is_in "$victim" FAILED
unfinished() { ! knotproof merge shard-1.jsonl > /dev/null 2>&1 && tail -n 1 shard-1.jsonl | grep -q '"record":"summary"'; }
check "its state is whole, and not finished" unfinished
scontrol requeue "$victim"
say "scontrol requeue $victim"
all_done() {
    local task
    for task in "${jobs[@]/%/_0}" "${jobs[@]/%/_1}" "${jobs[@]/%/_2}" "${jobs[@]/%/_3}"; do
        is_in "$task" COMPLETED || return 1
    done
}
wait_for "end of all tasks" 100 all_done
check "every task has ended well" all_done
[ "$(squeue -h | wc -l)" -eq 0 ] || give_up "tasks are left in the queue"

merged() { # merged FOLDER: the result there is that of one process.
    local code
    (cd "$1" && knotproof merge shard-*.jsonl --out result.jsonl > merge.txt)
    code=$?
    [ "$code" -le 1 ] && cmp "$1/result.jsonl" "$work/whole.jsonl"
}
check "merged, the shards of Slurm are the result of one process" merged "$work/slurm"
resubmitted() {
    local before job
    before=$(cat shard-*.jsonl | cksum)
    OFFSET=4 job=$(OFFSET=4 sbatch --parsable --array=0-3 --output=task-%A-%a.log shard.slurm)
    wait_for "tasks that have nothing to do" 30 all_of "$job"
    [ "$before" = "$(cat shard-*.jsonl | cksum)" ]
}
all_of() { is_in "$1_0" COMPLETED && is_in "$1_1" COMPLETED && is_in "$1_2" COMPLETED && is_in "$1_3" COMPLETED; }
check "tasks that are submitted again change nothing" resubmitted

# GNU parallel, stopped in the middle and started again.
cd "$work/parallel" || exit 1
bash recipe.sh > first.log 2>&1 &
runner=$!
first_is_done() { [ -f jobs.log ] && [ "$(wc -l < jobs.log)" -ge 2 ]; }
wait_for "first shard of GNU parallel" 40 first_is_done
# The second of these signals ends its tasks as well.
kill -TERM "$runner" $(pgrep -P "$runner") 2> /dev/null
sleep 0.1
kill -TERM $(pgrep -P "$runner") 2> /dev/null
wait "$runner" 2> /dev/null
say "GNU parallel stopped after $(($(wc -l < jobs.log) - 1)) of $SHARDS shards"
check "GNU parallel goes on with the rest" bash recipe.sh
check "merged, the shards of GNU parallel are the result of one process" merged "$work/parallel"
finish
