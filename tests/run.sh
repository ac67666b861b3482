#!/usr/bin/env bash
# Builds gonio as it is shipped and runs every test; arguments go to ctest.
#
#   tests/run.sh                    all of them
#   tests/run.sh -R MediaDisplay    those whose name matches
#
# GONIO_WERROR=ON turns warnings into errors. Ends with ctest's summary and its exit status.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"

bash cli/install-dependencies.sh --tests

export CMAKE_CXX_COMPILER_LAUNCHER=ccache
# The precompiled headers' times of day do not change what comes out.
export CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
# A checkout elsewhere finds what this one has compiled.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1
jobs=$(nproc)
cmake --preset release "-DGONIO_WERROR=${GONIO_WERROR:-OFF}" > /dev/null
cmake --build --preset release --parallel "$jobs"
exec ctest --test-dir build/release --output-on-failure --parallel "$jobs" --no-tests=error "$@"
