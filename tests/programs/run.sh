#!/usr/bin/env bash
# Runs what `gonio import` writes in the programs themselves: every light of lights.json over a grey floor, rendered and
# compared with `gonio probe` at 32 by 32 points.
#
#   bash tests/programs/run.sh [NAME…]
#
# NAME is a program (default: all): threejs, threejs-webgl, gltf (by three.js), babylon, playcanvas, filament, pathtracer
# (three-gpu-pathtracer), cycles, eevee. Prints a row for every program and light, and fails if a pixel differs by more than 1 % of
# the brightest, or by more than measured.csv states and a tenth. UPDATE=1 writes measured.csv. The tool is GONIO (build/release/cli/gonio). What is missing is
# installed: packages of npm into build/programs, Chromium and Blender by apt. LIGHTS=point,spot runs some lights alone.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
gonio=$(realpath "${GONIO:-$root/build/release/cli/gonio}")
work=$root/build/programs
all=(threejs threejs-webgl gltf babylon playcanvas filament pathtracer cycles eevee)
programs=("$@")
[[ $# -gt 0 ]] || programs=("${all[@]}")

declare -A target=([threejs]=threejs [threejs-webgl]=threejs [gltf]=gltf [babylon]=babylon [playcanvas]=playcanvas
    [filament]=filament [pathtracer]=threejs [cycles]=blender [eevee]=blender)
needs_chromium=false
needs_blender=false
for program in "${programs[@]}"; do
    [[ -n ${target[$program]:-} ]] || { echo "unknown program '$program': there are ${all[*]}" >&2; exit 2; }
    if [[ ${target[$program]} == blender ]]; then needs_blender=true; else needs_chromium=true; fi
done

missing=()
command -v jq >/dev/null || missing+=(jq)
$needs_chromium && { command -v chromium >/dev/null || missing+=(chromium); }
$needs_blender && { command -v blender >/dev/null || missing+=(blender python3-numpy); }
if ((${#missing[@]} > 0)); then
    sudo=()
    [[ $(id -u) -eq 0 ]] || sudo=(sudo)
    "${sudo[@]}" apt-get update -qq
    "${sudo[@]}" apt-get install -y --no-install-recommends "${missing[@]}" >/dev/null
fi
mkdir -p "$work"
packages=(three@0.187.0 three-mesh-bvh@0.9.17 three-gpu-pathtracer@0.0.26 @babylonjs/core@9.34.0 playcanvas@2.23.3
    filament@1.53.4 puppeteer-core@24)
if $needs_chromium; then
    for package in "${packages[@]}"; do
        [[ -d $work/node_modules/${package%@*} ]] || {
            npm install --prefix "$work" --no-save --no-audit --no-fund --legacy-peer-deps --silent "${packages[@]}"
            break
        }
    done
fi
echo '{ "type": "module" }' > "$work/package.json"

# The rigs, what probe says of them, and the files for the programs.
rm -rf "$work"/{rigs,probe,assets}
[[ -n ${LIGHTS:-} ]] || for program in "${programs[@]}"; do rm -f "$work/rendered/$program.json"; done
mkdir -p "$work"/{rigs,probe,assets,rendered}
cp "$root"/profiles/{street,pendant}.ies "$work/rigs"
"$gonio" preview --stage room --preset incandescent-60 --size 48x48 -o "$work/rigs/picture.png" -q
jq -c 'keys_unsorted' "$here/lights.json" > "$work/names.json"
mapfile -t lights < <(jq -r '.[]' "$work/names.json")
mapfile -t targets < <(for program in "${programs[@]}"; do echo "${target[$program]}"; done | sort -u)
for light in "${lights[@]}"; do
    jq --arg name "$light" '.[$name] as $light | { schema: "gonio.rig/1" } + if ($light | type) == "string"
        then { lights: [], sky: $light } else { lights: [{ name: $name } + $light] } end' \
        "$here/lights.json" > "$work/rigs/$light.json"
    "$gonio" probe --rig "$work/rigs/$light.json" --grid=-1,-1,0:2,0,0:0,2,0:32x32 --csv -q > "$work/probe/$light.csv"
    # A target without skies fails for a rig of a sky alone: then there is nothing to compare.
    for one in "${targets[@]}"; do
        "$gonio" import "$work/rigs/$light.json" --to "$one" -O "$work/assets" -q 2> "$work/import.log" ||
            grep -q UNS0101 "$work/import.log" || { cat "$work/import.log" >&2; exit 1; }
    done
done

failed=0
for program in "${programs[@]}"; do
    case $program in
    cycles | eevee)
        for light in "${lights[@]}"; do
            [[ -z ${LIGHTS:-} || ,$LIGHTS, == *,$light,* ]] || continue
            [[ -f $work/assets/blender/$light.py ]] || continue
            blender --background --factory-startup --python-exit-code 1 --python "$here/blender_floor.py" -- \
                "$program" "$work/assets/blender/$light.py" "$work/rendered/$program.json" "$light" > "$work/blender.log" 2>&1 ||
                { echo "$program: $light: not rendered, see $work/blender.log" >&2; failed=1; break; }
        done
        ;;
    *)
        node "$here/chromium.mjs" "$program" "$work" || failed=1
        ;;
    esac
done
pairs=()
for program in "${programs[@]}"; do pairs+=("$program=${target[$program]}"); done
node "$here/compare.mjs" "$work" "$here/measured.csv" "$([[ -n ${UPDATE:-} ]] && echo update || echo check)" \
    "${pairs[@]}" || failed=1
echo 'not run: Mitsuba, LuxCore, UsdLux (no library in npm or Debian), pbrt, Godot 4, Unity, Unreal'
echo 'elsewhere: Radiance (tests/radiance/run.sh), whole stages in Cycles (tests/preview/run.sh)'
exit $failed
