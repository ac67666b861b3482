#!/usr/bin/env bash
# Runs one file of tests of the Python module.   run.sh PYTHON FILE
set -euo pipefail
python=${1:?"usage: run.sh PYTHON FILE"}
file=${2:?"usage: run.sh PYTHON FILE"}
if ! "$python" -c 'import numpy, pytest' 2> /dev/null; then
    echo 'skipped: python3-numpy and python3-pytest are not installed'
    exit 77
fi
exec "$python" -m pytest -q -p no:cacheprovider "$file"
