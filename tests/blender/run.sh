#!/usr/bin/env bash
# Tries the Blender add-on in a headless Blender: installs it, imports profiles, turns lumens and kelvin, renders with
# Cycles, exports rigs and holds both against gonio probe. Needs Blender, so it is not part of the tests:
#
#   bash tests/blender/run.sh build/release/cli/gonio
set -euo pipefail

gonio=$(realpath "$1")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
work=$(dirname "$gonio")/../blender-check
rm -rf "$work" && mkdir -p "$work"
work=$(cd "$work" && pwd)
cd "$work"
PATH=$(dirname "$gonio"):$PATH
export PATH

cmake -E chdir "$root/lib/blender" cmake -E tar cf "$work/gonio_lights.zip" --format=zip gonio_lights
cp "$root"/profiles/{street,pendant,batwing}.{ies,ldt} .
cp "$root"/profiles/wall-washer.ies 'wall, washer.ies'
head -c 400 street.ies > 'cut off.ies'
echo 'no profile' > text.ies

# A home of its own, so that the add-on does not stay.
HOME=$work BLENDER_USER_RESOURCES=$work/user blender --background --factory-startup --python-exit-code 1 \
    --python "$here/check.py" -- "$work"
for rig in measured own; do
    "$gonio" probe --rig "$rig.json" --grid=-2,-2,-1:4,0,0:0,4,0:96x96 --csv -q > "$rig.probe.csv"
    python3 "$root/tests/import/compare_planes.py" "$rig.csv" "$rig.probe.csv" 0.003 0.03
done
