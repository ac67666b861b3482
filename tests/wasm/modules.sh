#!/usr/bin/env bash
# The modules for JavaScript against the tool: numbers, diagnostics and diagrams of every profile of the tree by
# gonio-core.mjs, and commands of every kind with all their files by gonio.mjs.
#
#   bash tests/wasm/modules.sh [GONIO]
#
# Builds the modules if they are not there. GONIO (build/release/cli/gonio) is the tool.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
tool=${1:-$root/build/release/cli/gonio}
built=$root/build/wasm
[[ -f $built/gonio.mjs && -f $built/gonio-core.mjs ]] ||
    GONIO_WASM_TARGETS='gonio-core-module gonio-module' bash "$root/lib/wasm/build.sh"
node "$root/tests/wasm/module.mjs" "$built/gonio-core.mjs" "$tool"
node "$root/tests/wasm/tool.mjs" "$built/gonio.mjs" "$tool"
