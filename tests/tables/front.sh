#!/usr/bin/env bash
# Prints the front of bytes against error of the tables of `gonio bake --table`, with the tables that three.js ships: its
# package comes from the npm registry. Needs node and npm, and the program gonio-table-front (-DGONIO_BENCH=ON).
#
#   tests/tables/front.sh GONIO-TABLE-FRONT WORK-FOLDER [CHART.svg]
#
# Fails if a table of three.js has a smaller error than one of gonio with at most as many bytes, or if the table with the
# same layout and bytes, or any of ltc-ggx, has a greater error than theirs in the median, in 95 % or at most.
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
((rows == 3)) || { echo "front.sh: $rows tables of three.js instead of 3" >&2; exit 1; }
if grep '^| three.js.*★' "$work/front.md"; then
    echo "front.sh: that table of three.js is on the front" >&2
    exit 1
fi
awk -F ' *[|] *' '
    /^\*\*/ { table = $0; gsub(/\*\*|:.*/, "", table) }
    /^\| three.js/ { bytes[table] = $4; for (k = 5; k < 8; ++k) theirs[table, k] = $k }
    /^\| / { row[++rows] = $0; of[rows] = table }
    END {
        for (r = 1; r <= rows; ++r) {
            split(row[r], field, / *[|] */)
            same = of[r] == "dfg" && field[2] == "linear, half" && field[3] == "16 x 16" ||
                   of[r] == "ltc-heitz" && field[2] == "heitz, half" && field[3] == "64 x 64" ||
                   of[r] == "ltc-ggx" && field[4] + 0 > 0
            compared[of[r]] += same
            for (k = 5; same && k < 8; ++k)
                if (field[k] + 0 > theirs[of[r], k] + 0) { print "front.sh: greater than that of three.js: " row[r]; failed = 1 }
        }
        if (compared["dfg"] != 1 || compared["ltc-heitz"] != 1 || compared["ltc-ggx"] < 16) { print "front.sh: rows are missing"; failed = 1 }
        exit failed
    }' "$work/front.md" >&2
