#!/usr/bin/env bash
# Builds gonio with the release settings and runs every test; arguments go to ctest.
#
#   tests/run.sh                    all of them
#   tests/run.sh -R MediaDisplay    those whose name matches
#
# Uses the build folder of cli/quickstart.sh, so no source is compiled twice. GONIO_WERROR=ON turns warnings into
# errors. Ends with ctest's summary and its exit status.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

bash cli/install-dependencies.sh --tests

jobs=$(nproc)
options=(-DBUILD_TESTING=ON -DGONIO_SHARED=ON)
# A value different from the folder's would recompile everything.
[[ -z ${GONIO_WERROR:-} ]] || options+=("-DGONIO_WERROR=$GONIO_WERROR")
cmake --preset release "${options[@]}" > /dev/null
cmake --build --preset release --parallel "$jobs"
exec ctest --test-dir build/release --output-on-failure --parallel "$jobs" --no-tests=error "$@"
