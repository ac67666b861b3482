#!/usr/bin/env bash
# Builds the library for WebAssembly and runs the unit tests of its rooms under Node. Arguments go to ctest.
#
#   bash tests/wasm/run.sh            all rooms
#   bash tests/wasm/run.sh -R web     one of them
#
# Left out are the tests of threads, of devices and signals, of the modules for pictures and display transforms, and of
# `gonio bench`, and those that compare with long double over many poses (CMakeLists.txt). Ends with ctest's summary and its exit status.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
GONIO_WASM_TARGETS='gonio gonio-wasm-unit' bash "$root/lib/wasm/build.sh" -DBUILD_TESTING=ON
exec ctest --test-dir "$root/build/wasm" --output-on-failure --parallel "$(nproc)" --no-tests=error "$@"
