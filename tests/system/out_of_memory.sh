#!/usr/bin/env bash
# If one input of a batch runs out of memory, only that input fails: the others are read, and the final line reports it.
# With whatever little memory the program starts, it says what it lacks.
#
#   tests/system/out_of_memory.sh GONIO
set -euo pipefail

gonio=$(realpath "$1")
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
cp "$root"/profiles/downlight.ies first.ies
cp "$root"/profiles/wall-washer.ies last.ies
# 1801 by 4001 angles: 7 million values, 58 MB as doubles, in a file just within the size limit.
{
    printf 'IESNA:LM-63-1995\nTILT=NONE\n1 -1 1 1801 4001 1 2 0 0 0\n1 1 0\n'
    seq 0 0.1 180
    seq 0 0.09 360
    yes 1 | head -7205801
} > big.ies || true
fail() {
    echo "FAILED: $*: $(cat said out)" >&2
    exit 1
}
limited() {
    status=0
    (ulimit -v 60000 && exec "$gonio" "$@") > out 2> said || status=$?
}
limited info first.ies
((status == 0)) || {
    echo "skipped: the tool does not start with 60 MB"
    exit 77
}

limited info -j 1 first.ies big.ies last.ies
((status == 5)) || fail "exit $status, not 5"
grep -q '^first.ies$' out || fail "the input before is not read"
grep -q '^last.ies$' out || fail "the input after is not read"
grep -q '^big.ies: error\[UNS0103\]: out of memory$' said || fail "the reason is not said"
grep -q '^3 files: 2 read, 1 failed$' said || fail "the closing line does not count it"

limited info -q big.ies
((status == 5)) || fail "-q: exit $status, not 5"
grep -q '^big.ies: error\[UNS0103\]: out of memory$' said || fail "-q hides the error"

limited info -j 1 --json first.ies big.ies
((status == 5)) || fail "--json: exit $status, not 5"
grep -q '"message": "out of memory"' out || fail "--json does not report it"

limited compare first.ies big.ies # no batch
((status == 5)) || fail "compare: exit $status, not 5"
grep -q 'error\[UNS0103\]: out of memory$' said || fail "compare does not say why"

# From the program's own size on: first the kernel cannot load it, then the loader cannot (127), then it runs.
said_so=0
loaded=0
least=$(($(stat --format %s "$gonio") / 1024))
for ((kb = least; kb < least + 6000; kb += 24)); do
    status=0
    (ulimit -v "$kb" && exec "$gonio" info -q first.ies) > out 2> said || status=$?
    grep -q 'error\[UNS0103\]: out of memory' said && said_so=$((said_so + 1))
    case $status in
    0 | 5 | 127) loaded=1 ;;
    126 | 137 | 139) ((loaded == 0)) || fail "with $kb KiB: exit $status" ;;
    *) fail "with $kb KiB: exit $status" ;;
    esac
done
((said_so > 0)) || fail "no limit shows what is missing"
echo "passed"
