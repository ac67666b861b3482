#!/usr/bin/env bash
# Whole commands of this tree beside those of an earlier commit, in alternation, as a table in Markdown:
#
#     bash tests/bench/against.sh COMMIT [--rounds N] [--only WORD]
#
# Builds the tool of COMMIT in a folder of its own ($GONIO_AGAINST, or one in the temporary folder; it is kept and used
# again for the same commit), and the tool of this tree in build/against. Both are release builds without tests.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
if [[ $# -lt 1 || $1 == -* ]]; then
    echo "usage: bash tests/bench/against.sh COMMIT [--rounds N] [--only WORD]" >&2
    exit 2
fi
commit=$(git -C "$here" rev-parse --verify --quiet "$1^{commit}") || {
    echo "error: '$1' is not a commit of this repository" >&2
    exit 2
}
shift
before=${GONIO_AGAINST:-${TMPDIR:-/tmp}/gonio-against}/$commit
if [[ ! -e $before/CMakeLists.txt ]]; then
    rm -rf "$before.new"
    mkdir -p "$before.new"
    git -C "$here" archive "$commit" | tar -x -C "$before.new"
    mv "$before.new" "$before"
fi
for tree in "$before" "$here"; do
    cmake -S "$tree" -B "$tree/build/against" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF >&2
    cmake --build "$tree/build/against" >&2
done
exec python3 "$here/tests/bench/against.py" "$before/build/against/cli/gonio" "$here/build/against/cli/gonio" "$@"
