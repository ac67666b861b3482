#!/usr/bin/env bash
# `gonio sheet` as PDF: the same bytes at any time and number of threads, and one message where something is missing.
#
#   tests/system/pdf.sh GONIO MODULE
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
gonio=$(realpath "$1")
module=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -rL "$root/profiles" "$work"
cd "$work"

fail() {
    echo "FAILED: $*" >&2
    exit 1
}
# refused STATUS CODE COMMAND…: the exit status and the code of the only error.
refused() {
    local expected=$1 code=$2 status=0
    shift 2
    "$@" > said 2>&1 || status=$?
    ((status == expected)) || fail "$*: exit $status: $(cat said)"
    [[ $(grep -c "error\[" said) == 1 ]] || fail "$*: $(cat said)"
    grep -q "error\[$code\]" said || fail "$*: $(cat said)"
}

inputs=(profiles/batwing.ldt profiles/street.ies profiles/downlight.xml)
"$gonio" sheet "${inputs[@]}" -j 1 -o once.pdf
sleep 1.1 # another second, which a date would show
TZ=Asia/Tokyo "$gonio" sheet "${inputs[@]}" -j 8 -o again.pdf
cmp once.pdf again.pdf || fail "another second, another file"
head -c 9 once.pdf | grep -qx '%PDF-1.5' || fail "no PDF"
tail -c 6 once.pdf | grep -qx '%%EOF' || fail "no end of a PDF"
[[ $(grep -ac '/FontFile[23]' once.pdf) -ge 2 ]] || fail "the fonts are not embedded"
[[ $(grep -acE '/Type /Page( |$)' once.pdf) == 6 ]] || fail "not two pages for each profile"

refused 5 UNS0105 "$gonio" sheet profiles/batwing.ldt --fonts "$work" -o lamp.pdf
grep -q 'fonts-dejavu-core' said || fail "the package of the fonts is not named"
echo 'no font' > DejaVuSans.ttf
cp DejaVuSans.ttf DejaVuSans-Bold.ttf
refused 4 INP0101 "$gonio" sheet profiles/batwing.ldt --fonts "$work" -o lamp.pdf
[[ ! -e lamp.pdf ]] || fail "there is a file"

# Without its module, PDF alone is refused.
mkdir -p alone/bin
cp "$gonio" alone/bin/gonio
refused 5 UNS0102 alone/bin/gonio sheet profiles/batwing.ldt -o lamp.pdf
grep -q 'gonio-pdf.so' said || fail "the module is not named"
alone/bin/gonio sheet profiles/batwing.ldt -o lamp.html
mkdir -p alone/lib/gonio
cp "$module" alone/lib/gonio
mkdir full
refused 3 'FIL01[0-9]*' "$gonio" sheet profiles/batwing.ldt --to pdf -o full
if [[ -w /dev/full ]]; then
    status=0
    "$gonio" sheet profiles/batwing.ldt --to pdf -o - > /dev/full 2> said || status=$?
    ((status == 3)) || fail "a full device: exit $status: $(cat said)"
fi

# A broken profile in a batch: the others have their pages.
head -c 300 profiles/batwing.ldt > broken.ldt
refused 4 'LDT[0-9]*' "$gonio" sheet profiles/batwing.ldt broken.ldt profiles/street.ldt -o two.pdf
[[ $(grep -acE '/Type /Page( |$)' two.pdf) == 4 ]] || fail "not the pages of the other two"
echo "passed"
