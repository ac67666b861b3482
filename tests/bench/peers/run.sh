#!/usr/bin/env bash
# Compares gonio with programs that others install as a package: reading IES files in three.js and Babylon.js (npm), a
# picture by Blender's Cycles, and how long programs take to print their version. Needs node, npm and their registry for
# the first, Blender and oiiotool if they are installed; skips what is missing. Not part of the tests.
#
#   bash tests/bench/peers/run.sh build/release/cli/gonio
set -euo pipefail

gonio=$(realpath "$1")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(dirname "$gonio")/../bench-peers
mkdir -p "$work"
work=$(cd "$work" && pwd)
cd "$work"
cp "$here"/*.mjs .
echo '{ "type": "module" }' > package.json

# A table of 73 planes by 181 gamma, 13 000 values, and a small one.
"$gonio" make street --planes 5deg --gammas 1deg -o large.ies -q
cp "$here/../../../profiles/street.ies" small.ies

seconds() { # the shortest of several runs: RUNS PROGRAM…; with CLOCK=processor the CPU time
    python3 - "$@" <<'P'
import os, sys, time
runs, command = int(sys.argv[1]), sys.argv[2:]
of_processor = os.environ.get("CLOCK") == "processor"
nothing = os.open(os.devnull, os.O_RDWR)
actions = [(os.POSIX_SPAWN_DUP2, nothing, stream) for stream in (0, 1, 2)]
best = 1e9
for _ in range(runs):
    start = time.perf_counter()
    _, status, used = os.wait4(os.posix_spawnp(command[0], command, os.environ, file_actions=actions), 0)
    if status != 0:
        sys.exit(f"{command[0]} failed")
    best = min(best, used.ru_utime + used.ru_stime if of_processor else time.perf_counter() - start)
print(f"{best:.6f}")
P
}

echo '| reading | bytes | program | us a file |'
echo '|---|---|---|---|'
for file in small.ies large.ies; do
    bytes=$(stat -c %s "$file")
    # The second thousand of a batch on one thread: excludes the start-up time.
    for count in 1000 2000; do for ((i = 0; i < count; ++i)); do echo "$file"; done > "$count.txt"; done
    first=$(CLOCK=processor seconds 9 "$gonio" info @1000.txt --jsonl -q -j 1)
    both=$(CLOCK=processor seconds 9 "$gonio" info @2000.txt --jsonl -q -j 1)
    python3 -c "print(f'| $file | $bytes | gonio info (read, flux, beam, symmetry; all of it reported) | {($both - $first) * 1e3:.1f} |')"
done
if command -v npm > /dev/null; then
    [[ -d node_modules/three && -d node_modules/@babylonjs/core ]] ||
        npm install --silent --no-fund --no-audit three@0.187.0 @babylonjs/core@9.34.0
    node read_ies.mjs small.ies large.ies
else
    echo 'npm is not installed: three.js and Babylon.js are left out'
fi

echo
echo '| start | ms |'
echo '|---|---|'
for program in /bin/true "$gonio version" "$gonio info small.ies" 'oiiotool --version' 'blender --version'; do
    command -v "${program%% *}" > /dev/null || { echo "| ${program%% *} | not installed |"; continue; }
    name=$program
    [[ $name == "$gonio"* ]] && name="gonio${name#"$gonio"}"
    runs=100
    [[ $name == blender* ]] && runs=5
    # shellcheck disable=SC2086 # a program and its option
    python3 -c "print(f'| $name | {$(seconds $runs $program) * 1e3:.2f} |')"
done

echo
echo '| picture of 256 x 256: a disk of 20 cm over a floor | s |'
echo '|---|---|'
python3 -c "print(f'| gonio preview, one thread, start and PNG with it | {$(seconds 5 "$gonio" preview --shape disk:r=20cm --intensity 800cd -s 256x256 -j 1 -o picture.png):.3f} |')"
if command -v blender > /dev/null; then
    for samples in 16 256; do
        blender --background --factory-startup --python "$here/cycles.py" -- "$samples" 2> /dev/null | grep '^|'
    done
else
    echo '| Blender | not installed |'
fi
