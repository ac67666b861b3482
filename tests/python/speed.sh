#!/usr/bin/env bash
# The module for Python against a C++ program that calls the same kernels, at a million points.   tests/python/speed.sh
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
cmake --build --preset release --target gonio-python gonio-python-speed > /dev/null
PYTHONPATH=build/release/python /usr/bin/python3 tests/python/speed.py build/release/tests/python/gonio-python-speed
