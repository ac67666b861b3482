#!/usr/bin/env bash
# The npm package as its users get it: packed, installed into an empty folder, used from Node in every function, with three.js
# and Babylon.js of the registry, and its declarations checked by TypeScript.
#
#   bash tests/npm/run.sh [GONIO_MJS [GONIO]]
#
# GONIO_MJS (build/wasm/gonio.mjs) is built by lib/wasm/build.sh if it is not there; GONIO (build/release/cli/gonio) is the
# tool, which results are compared with. The package runs in Node 18, the oldest, as well.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
module=${1:-$root/build/wasm/gonio.mjs}
tool=${2:-$root/build/release/cli/gonio}
[[ -f $module ]] || GONIO_WASM_TARGETS=gonio-module bash "$root/lib/wasm/build.sh"
module=$(realpath "$module")
tool=$(realpath "$tool")

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
node "$root/cli/npm/build.mjs" "$module" "$work/package"
(cd "$work" && npm pack --silent ./package > /dev/null)
mkdir "$work/user"
cd "$work/user"
npm init --yes > /dev/null
npm pkg set type=module
npm install --silent --no-audit --no-fund ../gonio-*.tgz three@0.187 @babylonjs/core@9 typescript@5 @types/node@18 @types/three@0.187
cp "$root"/tests/npm/*.mjs "$root/tests/wasm/facts.mjs" "$root/cli/npm/area_light_data.mjs" "$root/tests/npm/types.ts" .
stat --format 'package: %s bytes' ../gonio-*.tgz
node package.mjs "$tool" "$root/profiles"
node area_lights.mjs "$tool"
npm install --silent --no-audit --no-fund --prefix "$work/old" node@18
"$work/old/node_modules/node/bin/node" package.mjs "$tool" "$root/profiles"
npx tsc --noEmit --strict --module nodenext --moduleResolution nodenext --target es2022 --skipLibCheck types.ts
echo 'types: ok'
