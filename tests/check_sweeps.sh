#!/usr/bin/env bash
# Spreads sweeps over workers as docs/laboratory.md says, kills one of them in the middle, lets it go on, joins the parts and
# compares them with the whole sweep: everything but times must be equal. First by GNU parallel, then one as a job array of
# Slurm, whose daemons run here, on this machine alone.
#
#   check_sweeps.sh PATH_OF_DRAPEAU_LAB FOLDER     FOLDER is made anew
set -euo pipefail

lab=$1 folder=$2
shards=4
small=(report --set flag.columns=12 --set flag.rows=8 --settle 0.5 --seconds 0.25)
methods="semi-implicit-euler,leapfrog,rk4,xpbd"

# What is measured: sets sweep.
choose() {
    case $1 in
    trade) sweep=(trade "${small[@]}" --budget 0.25 --methods "$methods") ;;
    price) sweep=(price "${small[@]}" --budget 0.5) ;;
    converge) sweep=(converge "${small[@]}" --budget 0.5 --methods "$methods") ;;
    esac
}

rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"

fail() {
    echo "check: $*" >&2
    exit 1
}

# The records of some parts without their costs, in any order.
results() {
    grep -h -e '"result"' -e '"basis"' "$@" | sed 's/"cost":{[^}]*},//' | sort -u
}

# What a command found, without times and what follows from them. Points stand before the front, which does.
without_times() {
    sed -e '/"front":/,$d' -e '/"ms_per_second"/d' -e '/"cost_.*percent"/d' "$1"
}

# compared NAME WHOLE: the parts NAME-1.jsonl ... are the whole sweep, and merge says the same of them.
compared() {
    results "$2.jsonl" >"$2.results"
    results "$1"-*.jsonl >"$1.results"
    cmp "$2.results" "$1.results" || fail "$1: the shards together are not the whole sweep"
    "$lab" merge "$1"-*.jsonl --json "$1.json" --plot "$1.svg" >"$1.txt" || fail "$1: merge refused the parts"
    cmp <(without_times "$2.json") <(without_times "$1.json") || fail "$1: merge says something else than the whole sweep"
    echo "check: $1: $(grep -c '"result"' "$1.results") points in $shards shards, equal to the whole"
}

# killed_midway NAME PID: waits until the process has kept a point of NAME, then kills it with no warning.
kill_midway() {
    local part=$1 process=$2 tries=0
    until [ "$(grep -c '"result"' "$part" 2>/dev/null || true)" -ge 1 ] 2>/dev/null; do
        kill -0 "$process" 2>/dev/null || fail "$part: the worker ended before it could be killed"
        tries=$((tries + 1))
        [ "$tries" -lt 6000 ] || fail "$part: no point was kept in a minute"
        sleep 0.01
    done
    kill -KILL "$process" || fail "$part: the worker ended before it could be killed"
    echo "check: killed the worker of $part after $(grep -c '"result"' "$part") points"
}

# The process that writes a part, once there is one.
worker_of() {
    local tries=0 found
    until found=$(pgrep -f -- "drapeau-lab .*--part $1( |\$)" | while read -r process; do
        [ "$(readlink "/proc/$process/exe")" = "$(readlink -f "$lab")" ] && echo "$process"
    done | head -n 1) && [ -n "$found" ]; do
        tries=$((tries + 1))
        [ "$tries" -lt 3000 ] || fail "$1: no worker appeared in half a minute"
        sleep 0.01
    done
    echo "$found"
}

# by_parallel NAME WHOLE
by_parallel() {
    local name=$1 whole=$2
    spread() {
        parallel --will-cite --jobs 2 "$lab" "${sweep[@]}" --shard "{}/$shards" --part "$name-{}.jsonl" --resume \
            ::: $(seq "$shards") >>"$name.log" 2>&1
    }
    spread &
    local all=$!
    kill_midway "$name-2.jsonl" "$(worker_of "$name-2.jsonl")"
    if wait "$all"; then fail "parallel did not notice that a worker was killed"; fi
    if "$lab" merge "$name"-*.jsonl >merge.log 2>&1; then fail "merge did not notice that points are missing"; fi
    grep -E "(is|are) missing" merge.log
    spread || fail "a worker failed ($name.log)"
    compared "$name" "$whole"
}

daemons=()
stop_daemons() {
    local file
    for file in "${daemons[@]}"; do
        if [ -s "$file" ]; then kill "$(cat "$file")" 2>/dev/null || true; fi
    done
}

# A cluster of one node, this machine, with everything it writes in a folder of its own.
start_slurm() {
    local here=$1 host
    host=$(hostname -s)
    mkdir -p "$here/state" "$here/spool"
    cat >"$here/slurm.conf" <<END
ClusterName=drapeau
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$here/munge.socket
CredType=cred/munge
StateSaveLocation=$here/state
SlurmdSpoolDir=$here/spool
SlurmctldPidFile=$here/slurmctld.pid
SlurmdPidFile=$here/slurmd.pid
SlurmctldLogFile=$here/slurmctld.log
SlurmdLogFile=$here/slurmd.log
SlurmctldPort=$((20000 + RANDOM % 5000))
SlurmdPort=$((25000 + RANDOM % 5000))
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
ReturnToService=2
JobRequeue=1
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
    export SLURM_CONF=$here/slurm.conf
    daemons=("$here/slurmd.pid" "$here/slurmctld.pid" "$here/munged.pid")
    trap stop_daemons EXIT
    (umask 077 && head -c 1024 /dev/urandom >"$here/munge.key")
    (umask 022 && munged --force --socket "$here/munge.socket" --key-file "$here/munge.key" \
        --pid-file "$here/munged.pid" --log-file "$here/munged.log" --seed-file "$here/munge.seed") ||
        fail "munged did not start ($here/munged.log)"
    slurmctld -c || fail "slurmctld did not start ($here/slurmctld.log)"
    # Control groups are not needed; where they cannot be used, later versions let them be switched off.
    if ! slurmd -N "$host"; then
        echo "CgroupPlugin=disabled" >"$here/cgroup.conf"
        slurmd -N "$host" || fail "slurmd did not start ($here/slurmd.log): $(tail -n 1 "$here/slurmd.log")"
    fi
    local tries=0
    until [ "$(timeout 5 sinfo -h -o %t 2>/dev/null)" = idle ]; do
        tries=$((tries + 1))
        [ "$tries" -lt 100 ] || fail "the node of Slurm is not ready after some time: $(timeout 5 sinfo -h -N -o '%t %E' || true)"
        sleep 0.3
    done
}

submitted() {
    timeout 600 sbatch --quiet --wait --array="1-$shards" --output=slurm-%a.log --open-mode=append --wrap \
        "exec $lab ${sweep[*]} --shard \$SLURM_ARRAY_TASK_ID/$shards --part slurm-\$SLURM_ARRAY_TASK_ID.jsonl --resume"
}

by_slurm() {
    [ "$(id -u)" -eq 0 ] || fail "Slurm's daemons are started as root; run this as root"
    start_slurm "$folder/slurm"
    submitted &
    local all=$!
    kill_midway slurm-2.jsonl "$(worker_of slurm-2.jsonl)"
    if wait "$all"; then fail "Slurm did not notice that a worker was killed"; fi
    if "$lab" merge slurm-*.jsonl >merge.log 2>&1; then fail "merge did not notice that points are missing"; fi
    grep -E "(is|are) missing" merge.log
    submitted || fail "a task of the job array failed (slurm-*.log)"
    compared slurm trade-whole
}

for name in trade price converge; do
    choose "$name"
    "$lab" "${sweep[@]}" --part "$name-whole.jsonl" --json "$name-whole.json" >"$name-whole.txt" 2>"$name-whole.log" ||
        fail "the whole sweep of $name failed"
    by_parallel "$name-parallel" "$name-whole"
done
choose trade
by_slurm
echo "check: sweeps spread over workers, one of them killed, equal the whole"
