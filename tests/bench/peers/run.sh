#!/usr/bin/env bash
# gonio beside what others install as a package: reading IES files in three.js and Babylon.js (npm), a picture by
# Blender's Cycles, and how long programs take to say their version. Needs node, npm and their registry for the first,
# Blender and oiiotool where they are there; leaves out what is not. No part of the tests.
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

# A table of 73 planes by 181 gamma, 13 000 values, beside a small one.
"$gonio" make street --planes 5deg --gammas 1deg -o large.ies -q
cp "$here/../../../profiles/street.ies" small.ies

seconds() { # of one run, the least of five
    python3 - "$@" <<'P'
import subprocess, sys, time
best = 1e9
for _ in range(5):
    start = time.perf_counter()
    subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    best = min(best, time.perf_counter() - start)
print(f"{best:.6f}")
P
}

echo '| reading | bytes | program | us a file |'
echo '|---|---|---|---|'
for file in small.ies large.ies; do
    bytes=$(stat -c %s "$file")
    # The second thousand of a batch on one thread: without what the start takes.
    for count in 1000 2000; do for ((i = 0; i < count; ++i)); do echo "$file"; done > "$count.txt"; done
    first=$(seconds "$gonio" info @1000.txt --jsonl -q -j 1)
    both=$(seconds "$gonio" info @2000.txt --jsonl -q -j 1)
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
for program in /bin/true "$gonio version" 'oiiotool --version' 'blender --version'; do
    command -v "${program%% *}" > /dev/null || { echo "| ${program%% *} | not installed |"; continue; }
    # shellcheck disable=SC2086 # a program and its option
    name=$program; [[ $name == "$gonio"* ]] && name='gonio version'
    python3 -c "print(f'| $name | {$(seconds $program) * 1e3:.2f} |')"
done

echo
echo '| picture of 256 x 256: a disk of 20 cm over a floor | s |'
echo '|---|---|'
python3 -c "print(f'| gonio preview, one thread, start and PNG with it | {$(seconds "$gonio" preview --shape disk:r=20cm --intensity 800cd -s 256x256 -j 1 -o picture.png):.3f} |')"
if command -v blender > /dev/null; then
    for samples in 16 256; do
        blender --background --factory-startup --python "$here/cycles.py" -- "$samples" 2> /dev/null | grep '^|'
    done
else
    echo '| Blender | not installed |'
fi
