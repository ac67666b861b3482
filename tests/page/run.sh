#!/usr/bin/env bash
# Builds the page and tests it in headless Chromium, and the main of it in headless Firefox.
#
#   bash tests/page/run.sh [GONIO_PAGE_MJS [GONIO [CORPUS]]]
#
# GONIO_PAGE_MJS (build/wasm/gonio-page.mjs) is the module of cli/wasm for the page, built by lib/wasm/build.sh if it is not there; GONIO
# (build/release/cli/gonio) is the native tool of the same source. CORPUS is a folder of profiles with good/ and
# bad/; without one, ../shared/corpus beside the checkout is used if it is there. The browsers are installed by apt where they are
# missing, two packages of npm into build/page. Screenshots and figures are left in build/page.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
module=${1:-$root/build/wasm/gonio-page.mjs}
[[ -f $module ]] || GONIO_WASM_TARGETS=gonio-page-module bash "$root/lib/wasm/build.sh"
module=$(realpath "$module")
tool=$(realpath "${2:-$root/build/release/cli/gonio}")
corpus=${3:-$root/../shared/corpus}
build=$root/build/page
mkdir -p "$build"

if ! command -v chromium >/dev/null || ! command -v firefox-esr >/dev/null; then
    sudo=()
    [[ $(id -u) -eq 0 ]] || sudo=(sudo)
    "${sudo[@]}" apt-get update -qq
    "${sudo[@]}" apt-get install -y --no-install-recommends chromium firefox-esr fonts-dejavu-core >/dev/null
fi
if [[ ! -d $build/node_modules/puppeteer-core || ! -d $build/node_modules/axe-core ]]; then
    npm install --prefix "$build" --no-save --no-audit --no-fund puppeteer-core@24 axe-core@4
fi

node "$root/cli/page/build.mjs" "$module" "$build/gonio.html"
node "$root/tests/page/firefox.mjs" "$build" "$tool"
exec node "$root/tests/page/page.mjs" "$build" "$tool" "$corpus"
