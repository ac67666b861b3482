#!/usr/bin/env bash
# Bakes a catalogue of 2000 made profiles once in a single run, once as a job array under Slurm and once by GNU parallel,
# by the lines of cli/bake/README.md. A task that dies is missed by --merge and run again alone. The textures and the
# merged manifests must be those of the single run, byte for byte. Brings up Slurm and munge on this machine, as root;
# needs Debian's slurm-wlm, munge and parallel, so it is not part of the tests:
#
#   bash tests/cluster/run.sh build/release/cli/gonio
set -euo pipefail

gonio=$(realpath "$1")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
page=$here/../../cli/bake/README.md
for program in slurmctld slurmd munged sbatch parallel; do
    command -v "$program" > /dev/null || PATH=$PATH:/usr/sbin
    command -v "$program" > /dev/null || { echo "needs $program: apt-get install slurm-wlm munge parallel" >&2; exit 2; }
done
work=$(mktemp -d)
PATH=$(dirname "$gonio"):$PATH
export PATH

started=()
stop() {
    for pid in "${started[@]}"; do kill "$pid" 2> /dev/null || true; done
    wait
    rm -rf "$work"
}
trap stop EXIT

# Blocks of the page that begin with the given line.
block() {
    awk -v first="$1" '/^```/ { inside = !inside && $0 ~ /^```(bash|sh)$/; line = 0; shown = 0; next }
        inside { if (line++ == 0 && index($0, first) == 1) shown = 1; if (shown) print }' "$page"
}

cd "$work"
mkdir profiles single slurm_array parallel
shapes=(downlight:beam=36deg batwing wall-washer street gaussian:beam=20deg)
for i in $(seq 2000); do
    "$gonio" make "${shapes[i % 5]}" --lumens "$((500 + i))lm" -q -o "profiles/lamp$i.ies"
done
for folder in single slurm_array parallel; do
    seq -f '../profiles/lamp%g.ies' 2000 > "$folder/catalogue.txt"
    mkdir "$folder/textures" "$folder/log"
done

echo '== A single run'
(cd single && time "$gonio" bake @catalogue.txt --normalize peak -s 64x64 -O textures -u -q --manifest textures.json)

echo '== Slurm'
host=$(hostname -s)
mkdir -p slurm/state slurm/spool slurm/log /run/munge
[[ -s /etc/munge/munge.key ]] || mungekey --create
chown -R munge: /run/munge /var/log/munge /var/lib/munge /etc/munge
pgrep -x munged > /dev/null || {
    runuser -u munge -- munged --foreground > slurm/log/munged.txt 2>&1 &
    started+=($!)
}
cat > slurm/slurm.conf << END
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
StateSaveLocation=$work/slurm/state
SlurmdSpoolDir=$work/slurm/spool
SlurmctldPidFile=$work/slurm/slurmctld.pid
SlurmdPidFile=$work/slurm/slurmd.pid
SlurmctldLogFile=$work/slurm/log/slurmctld.txt
SlurmdLogFile=$work/slurm/log/slurmd.txt
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=main Nodes=$host Default=YES State=UP
END
export SLURM_CONF=$work/slurm/slurm.conf
slurmctld -D > slurm/log/controller.txt 2>&1 &
started+=($!)
slurmd -D > slurm/log/node.txt 2>&1 &
started+=($!)
for _ in $(seq 60); do
    sinfo --noheader --format=%t 2> /dev/null | grep -q idle && break
    sleep 0.5
done
sinfo

cd slurm_array
block '#!/bin/bash' > bake.sh
grep -q SLURM_ARRAY_TASK_ID bake.sh
# Task 7 dies the first time, as if its machine had been switched off.
# shellcheck disable=SC2016 # for the task's shell
sed '/^gonio/i [[ $SLURM_ARRAY_TASK_ID != 7 || -e came_back ]] || { touch came_back; kill -KILL $$; }' bake.sh > dying.sh
time sbatch --wait dying.sh && { echo 'a dying task was not noticed' >&2; exit 1; }
"$gonio" bake --merge log/*.json -o textures.json && { echo 'a missing shard was not noticed' >&2; exit 1; }
[[ ! -e textures.json ]]
sbatch --wait --array=7 bake.sh
"$gonio" bake --merge log/*.json -o textures.json
cd ..

echo '== GNU parallel'
cd parallel
line=$(block 'parallel gonio')
[[ -n $line ]]
time bash -c "$line" 2> log/parallel.txt
"$gonio" bake --merge log/*.json -o textures.json
cd ..

for folder in slurm_array parallel; do
    cmp single/textures.json "$folder/textures.json"
    diff -r single/textures "$folder/textures"
done
echo "$(find single/textures -type f | wc -l) files and the manifest are the same, by one run, Slurm and GNU parallel"
