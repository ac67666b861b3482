#!/usr/bin/env bash
# Scenes that preview exports for Blender, rendered by Cycles, against preview's own pictures, including shadows.
# Opt-in: needs Blender and python3-openimageio, and takes minutes on one core.
#
#   bash tests/preview/run.sh GONIO [CASE…]
set -euo pipefail

gonio=$(realpath "${1:?"usage: run.sh GONIO [CASE…]"}")
shift
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
profiles=$here/../../profiles
work=$(dirname "$gonio")/../preview-check
mkdir -p "$work"
cd "$work"
command -v blender > /dev/null || { echo 'Blender is not installed: skipped'; exit 0; }

wanted=" $* "
failed=0
# NAME LIGHT_NT PREVIEW-OPTION…: pixels above LIGHT_NT are visible lights.
check() {
    local name=$1 light_nt=$2
    shift 2
    [[ $wanted == "  " || $wanted == *" $name "* ]] || return 0
    "$gonio" preview --indirect "${indirect:-off}" "$@" -s "${size:-256x256}" -o "$name.exr" --export "$name.py" -q
    nice -n "${niceness:-5}" blender --background --factory-startup -t 1 --python "$name.py" \
        --python-expr "import bpy; bpy.context.scene.cycles.samples = ${samples:-256}" \
        -o "$PWD/$name.cycles." -f 1 > "$name.log" 2>&1 || { tail -n 40 "$name.log"; exit 1; }
    mv "$name.cycles.0001.exr" "$name.cycles.exr"
    echo "$name"
    /usr/bin/python3 "$here/compare_pictures.py" "$name.cycles.exr" "$name.exr" "$light_nt" "$name.difference.png" ||
        failed=1
}

matte() { # all surfaces with these names
    local surface
    for surface in "$@"; do echo "--material $surface=lambert:albedo=0.5"; done
}
# A tube is a mesh of many triangles, and therefore noisy; so are paths with many bounces.
# shellcheck disable=SC2046 # options are words
{
    check sphere 300 --shape sphere:r=10cm --intensity 800lm --stage floor $(matte floor wall sphere)
    check disk 300 --shape disk:r=15cm --intensity 900lm --stage spheres $(matte floor sphere)
    check ellipse 900 --shape ellipse:w=60cm,h=20cm --intensity 2000lm --stage room --position 0,0,2.3 $(matte floor ceiling wall box sphere)
    check gltf 300 --shape disk:r=15cm --intensity 900lm --stage spheres $(matte floor) --material sphere=gltf:base=0.9,metallic=1,roughness=0.6
    check rect 900 --shape rect:w=60cm,h=30cm --intensity 2000lm --stage room --position 0,0,2.3 $(matte floor ceiling wall box sphere)
    samples=4096 check tube 900 --shape tube:r=2cm,l=1.2m --intensity 1500lm --stage room $(matte floor ceiling wall box sphere)
    check spot 1e9 --shape spot:outer=30deg,inner=20deg --intensity 1000cd --stage card $(matte floor card stand)
    check street 1e9 "$profiles/street.ies" --stage street $(matte road kerb pavement verge pole)
    check figure 1e9 "$profiles/batwing.ies" --stage room --figure $(matte floor ceiling wall box sphere)
    check sun 1e9 --shape sun:angle=0.53deg --intensity 1000lx --direction 0.3,0.5,-1 --stage floor $(matte floor wall sphere)
    # A sky that every direction tells from the others; once with walls that bounce its light.
    check sky 1e9 --sky cie:12,sun=120/25,horizontal=20klx,ground=0.2 --stage spheres $(matte floor sphere)
    check uniform-sky 1e9 --sky 500lx --stage floor $(matte floor wall sphere)
    indirect=all samples=4096 check bounced-room 900 --shape rect:w=60cm,h=30cm --intensity 2000lm --stage room --position 0,0,2.3 $(matte floor ceiling wall box sphere)
    indirect=all samples=4096 check bounced-corridor 1e9 --shape disk:r=15cm --intensity 2000lm --stage corridor $(matte floor ceiling wall)
    check outside 1e9 --shape point --intensity 100cd --stage room --camera 0,-6,1.5 --target 0,0,1.2 $(matte floor ceiling wall box sphere)
}
exit "$failed"
