#!/usr/bin/env bash
# Loads the output of import and preview --export into its target programs: three.js, Babylon.js and Khronos' glTF
# validator from npm, and Blender if it is installed. Needs node, npm and their registry, so it is not part of the
# tests:
#
#   bash tests/import/run.sh build/release/cli/gonio
set -euo pipefail

gonio=$(realpath "$1")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(dirname "$gonio")/../import-check
mkdir -p "$work"
work=$(cd "$work" && pwd)
cd "$work"
rm -rf assets && mkdir assets
[[ -d node_modules/gltf-validator && -d node_modules/three && -d node_modules/@babylonjs/core ]] ||
    npm install --silent --no-fund --no-audit gltf-validator@2.0.0-dev.3.10 three@0.187.0 @babylonjs/core@9.34.0
echo '{ "type": "module" }' > assets/package.json
cp "$here"/*.mjs .

lamps=(street wall-washer batwing pendant)
for lamp in "${lamps[@]}"; do echo "$here/../../profiles/$lamp.ies"; done > lamps.txt
"$gonio" import @lamps.txt --to gltf,threejs,babylon,blender -O assets -q

"$gonio" import "$here/studio.json" --to gltf,threejs,babylon,blender -O assets -q --allow-outside

echo '== glTF validator'
mkdir assets/stages
for stage in spheres room street; do
    for ending in gltf glb; do
        "$gonio" preview "$here/../../profiles/street.ies" --stage "$stage" --figure -q --export "assets/stages/$stage.$ending"
    done
done
node gltf_check.mjs assets/gltf/*.gltf assets/gltf/*.glb assets/stages/*.gltf assets/stages/*.glb

echo '== A rig in three.js and Babylon.js'
for at in -1.2,0.9,-1 0,0,-1 0.7,-0.8,-1 1.6,1.4,-1 0.3,0.4,-0.8; do
    "$gonio" probe --rig "$here/studio.json" --allow-outside --at "$at" --normal 0,0,1 --json |
        jq '.points[0] | {position, lights: (.lights | map({(.name): .illuminance_lx}) | add)}'
done | jq -s . > studio.points.json
node scene_check.mjs three assets/threejs/studio.js < studio.points.json
node scene_check.mjs babylon assets/babylon/studio.js < studio.points.json

echo '== A sky in three.js and Babylon.js'
sky=cie:12,sun=120/25,horizontal=20klx,color=4000K,ground=0.2
echo "{\"schema\": \"gonio.rig/1\", \"lights\": [], \"sky\": \"$sky\"}" > sky.json
"$gonio" import sky.json --to threejs,babylon -O assets -q
"$gonio" sky info "$sky" --json > sky.info.json
node sky_check.mjs three assets/threejs/sky.js < sky.info.json
node sky_check.mjs babylon assets/babylon/sky.js < sky.info.json

# Directions off the texel grid, all around.
directions() {
    for c in 0.3 31.7 77.5 90 121.25 179.9 203.6 270 299.4 359.9; do
        for gamma in 0.1 3.7 12.2 25 33.3 48.6 61.5 74.9 84.2 88.8 95.5 120.3 151.7 179.2; do echo "$c,$gamma"; done
    done
}
echo '== three.js'
for lamp in "${lamps[@]}"; do
    directions | "$gonio" sample "$here/../../profiles/$lamp.ies" - --json |
        jq -r '.samples[] | "\(.c_deg),\(.gamma_deg),\(.cd)"' | node threejs_check.mjs "assets/threejs/$lamp.js"
done

echo '== Babylon.js'
for lamp in "${lamps[@]}"; do
    for gamma in 0.1 3.7 12.2 25 33.3 48.6 61.5 74.9 84.2 95.5 120.3 151.7 179.2; do
        for ((c = 1; c < 360; c += 2)); do echo "$c,$gamma"; done
    done | "$gonio" sample "$here/../../profiles/$lamp.ies" - --json |
        jq -r '.samples | group_by(.gamma_deg)[] | "\(.[0].gamma_deg),\(map(.cd) | add / length)"' |
        node babylon_check.mjs "assets/babylon/$lamp.js"
done

if command -v blender > /dev/null; then
    echo '== Blender'
    for lamp in "${lamps[@]}"; do
        blender --background --factory-startup --python "$here/blender_plane.py" -- \
            "assets/blender/$lamp.py" "$lamp.csv" > blender.log 2>&1 || { cat blender.log; exit 1; }
        "$gonio" probe "$here/../../profiles/$lamp.ies" --grid=-2,-2,-1:4,0,0:0,4,0:160x160 --csv > "$lamp.probe.csv"
        python3 "$here/compare_planes.py" "$lamp.csv" "$lamp.probe.csv"
    done
    # A rig, with 1024 samples per pixel: its area lights are noisy, most of all the tube, a mesh of many triangles.
    blender --background --factory-startup --python "$here/blender_plane.py" -- \
        assets/blender/studio.py studio.csv 1024 > blender.log 2>&1 || { cat blender.log; exit 1; }
    "$gonio" probe --rig "$here/studio.json" --allow-outside --grid=-2,-2,-1:4,0,0:0,4,0:160x160 --csv > studio.probe.csv
    python3 "$here/compare_planes.py" studio.csv studio.probe.csv 0.002 0.03
    # Openings, masks and images: their pictures lie beside the rig.
    mkdir -p near
    cp "$here/near.json" "$here"/../../profiles/{batwing,pendant,wall-washer}.ies near
    "$gonio" bake "$here/../../profiles/street.ies" --layout gnomonic --normalize peak -s 64x64 -o near/gobo.exr -q --overwrite
    "$gonio" preview --stage room --preset incandescent-60 --size 48x32 -o near/picture.png -q --overwrite
    "$gonio" import near/near.json --to blender -O assets -q
    blender --background --factory-startup --python "$here/blender_plane.py" -- \
        assets/blender/near.py near.csv 1024 > blender.log 2>&1 || { cat blender.log; exit 1; }
    "$gonio" probe --rig near/near.json --grid=-2,-2,-1:4,0,0:0,4,0:96x96 --csv > near.probe.csv
    python3 "$here/compare_planes.py" near.csv near.probe.csv 0.002 0.03
else
    echo 'Blender is not installed: skipped'
fi
