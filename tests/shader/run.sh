#!/usr/bin/env bash
# Checks what `gonio shader` prints: every function in every language by compilers, and 10,000 random poses of each in
# headless Chromium, by WebGL 2 (GLSL ES) and WebGPU (WGSL), against the core in double.
#
#   bash tests/shader/run.sh [BUILD]
#
# BUILD is a configured build folder (build/release). What is missing is installed by apt, one package of npm into
# BUILD/shader. Prints the tables of lib/gonio/shader/README.md: instructions after spirv-opt, errors, and time beside
# shaders written by hand (by_hand/).
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$(realpath "${1:-$root/build/release}")
work=$build/shader
mkdir -p "$work"

missing=()
command -v glslangValidator >/dev/null || missing+=(glslang-tools)
command -v spirv-val >/dev/null || missing+=(spirv-tools)
command -v spirv-cross >/dev/null || missing+=(spirv-cross)
command -v chromium >/dev/null || missing+=(chromium)
if ((${#missing[@]} > 0)); then
    sudo=()
    [[ $(id -u) -eq 0 ]] || sudo=(sudo)
    "${sudo[@]}" apt-get update -qq
    "${sudo[@]}" apt-get install -y --no-install-recommends "${missing[@]}" >/dev/null
fi
if [[ ! -d $work/node_modules/puppeteer-core ]]; then
    npm install --prefix "$work" --no-save --no-audit --no-fund puppeteer-core@24
fi

cmake --build "$build" --target gonio-tool gonio-shader-cases
bash "$root/tests/shader/include.sh" "$build/cli/gonio"
rm -rf "$work/made"
"$build/tests/gonio-shader-cases" "$work/made" "$root/tests/shader/by_hand"
bash "$root/tests/shader/compilers.sh" "$work/made"
node "$root/tests/shader/browser.mjs" "$work"
node "$root/tests/shader/lookups.mjs" "$work" "$build/cli/gonio"
