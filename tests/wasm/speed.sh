#!/usr/bin/env bash
# The kernels and the preview in WebAssembly against the processor: milliseconds, and native time / WebAssembly time.
#
#   bash tests/wasm/speed.sh
#
# Both programs run in turn on one thread, twice, and the lesser median of processor times counts.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
cmake --build --preset release --target gonio-wasm-speed > /dev/null
GONIO_WASM_TARGETS=gonio-wasm-speed bash lib/wasm/build.sh -DBUILD_TESTING=ON > /dev/null
for _ in 1 2 3; do
    build/release/tests/gonio-wasm-speed
    node build/wasm/tests/wasm/gonio-wasm-speed.js
done | awk '
    { ms = $NF; set = $(NF - 1); name = $0; sub(/ +[^ ]+ +[^ ]+$/, "", name)
      if (!(name in known)) { known[name] = 1; names[++count] = name }
      # "scalar" comes from both programs, the native one first
      if (set == "scalar") set = ++runs[name] % 2 ? "scalar" : "wasm"
      if (!((name, set) in least) || ms < least[name, set]) least[name, set] = ms }
    END {
      printf "%-24s %8s %8s %8s %8s %8s %8s\n", "ms", "scalar", "sse2", "wasm", "wasm128", "scalar %", "sse2 %"
      for (i = 1; i <= count; ++i) { n = names[i]
        printf "%-24s %8.3f %8.3f %8.3f %8.3f", n, least[n, "scalar"], least[n, "sse2"], least[n, "wasm"], least[n, "wasm128"]
        printf " %8.0f", 100 * least[n, "scalar"] / least[n, "wasm"]
        if (least[n, "wasm128"] > 0) printf " %8.0f", 100 * least[n, "sse2"] / least[n, "wasm128"]
        printf "\n" } }'
