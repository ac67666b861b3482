#!/usr/bin/env bash
# Area lights in three.js: its own RectAreaLight, those of the npm package (cli/npm/three-area-lights.mjs) and the truth by
# quadrature at the same pixels, in headless Chromium. Prints the tables of cli/npm/AREA_LIGHTS.md.
#
#   bash tests/shader/three.sh [BUILD]
#
# BUILD is a configured build folder (build/release) with the tool. What is missing is installed: chromium by apt, two
# packages of npm into BUILD/shader/three-THREE, where the pictures are left as well. THREE (0.187.0) is the release of
# three.js.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$(realpath "${1:-$root/build/release}")
three=${THREE:-0.187.0}
work=$build/shader/three-$three
mkdir -p "$work"
if ! command -v chromium > /dev/null; then
    sudo=()
    [[ $(id -u) -eq 0 ]] || sudo=(sudo)
    "${sudo[@]}" apt-get update -qq
    "${sudo[@]}" apt-get install -y --no-install-recommends chromium > /dev/null
fi
if [[ ! -d $work/node_modules/puppeteer-core ]]; then
    npm install --prefix "$work" --no-save --no-audit --no-fund --silent "three@$three" puppeteer-core@24
fi
cmake --build "$build" --target gonio-tool gonio-three-truth
node "$root/tests/shader/three/three.mjs" "$work" "$build/cli/gonio" "$build/tests/gonio-three-truth"
