#!/usr/bin/env bash
# Prints the front of bytes against error of the tables of `gonio bake --table`, with the tables that three.js ships: its
# package comes from the npm registry. Needs node and npm, and the program gonio-table-front (-DGONIO_BENCH=ON).
#
#   tests/tables/front.sh GONIO-TABLE-FRONT WORK-FOLDER [CHART.svg]
#
# Fails if a table of three.js has a smaller error than one of gonio with at most as many bytes.
set -euo pipefail

program=$(realpath "${1:?"usage: front.sh GONIO-TABLE-FRONT WORK-FOLDER [CHART.svg]"}")
work=${2:?"usage: front.sh GONIO-TABLE-FRONT WORK-FOLDER [CHART.svg]"}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$work"
[[ -d $work/node_modules/three ]] || npm install --prefix "$work" --no-audit --no-fund --silent three@0.187.0
node "$here/published.mjs" "$work"
"$program" "$work" | tee "$work/front.md"
[[ -z ${3:-} ]] || "$program" "$work" --chart > "$3"

# A row of three.js with a star is on the front: nothing of gonio has fewer bytes and a smaller error.
rows=$(grep -c '^| three.js' "$work/front.md") || true
((rows == 2)) || { echo "front.sh: $rows tables of three.js instead of 2" >&2; exit 1; }
if grep '^| three.js.*★' "$work/front.md"; then
    echo "front.sh: that table of three.js is on the front" >&2
    exit 1
fi
