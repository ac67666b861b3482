#!/usr/bin/env bash
# Checks GLDF against its schema: what gonio writes, and files of others.
#
#   tests/gldf/run.sh GONIO SCHEMA [FILE.gldf…]   SCHEMA is gldf.xsd, from the repository of GLDF
#
# Every profile of the tree, and two whose texts need escaping, are written as GLDF; xmllint (libxml2-utils) validates each
# product.xml. Files of others are validated too, and gonio must read those that are valid: `gonio check` may find
# something in their photometries, but must not call them unreadable.
set -euo pipefail

gonio=$(realpath "${1:?"usage: run.sh GONIO SCHEMA [FILE.gldf…]"}")
schema=$(realpath "${2:?"usage: run.sh GONIO SCHEMA [FILE.gldf…]"}")
shift 2
command -v xmllint > /dev/null || { echo 'run.sh: xmllint is missing: apt-get install libxml2-utils' >&2; exit 5; }
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

product_of() { # FILE.gldf
    python3 -c 'import sys, zipfile
archive = zipfile.ZipFile(sys.argv[1])
assert archive.testzip() is None
sys.stdout.buffer.write(archive.read("product.xml"))' "$1" > "$work/product.xml"
}

failed=0
written=0
sed 's/^\[MANUFAC\].*/[MANUFAC] "Lights" \& <Sons>/; s/^\[LUMINAIRE\].*/[LUMINAIRE] Größe/' "$root/profiles/street.ies" > "$work/texts.ies"
sed '/^\[MANUFAC\]/d; /^\[LUM/d' "$root/profiles/street.ies" > "$work/silent.ies"
for profile in "$root"/profiles/*.ies "$root"/profiles/*.ldt "$root"/profiles/*.xml "$work"/*.ies; do
    "$gonio" convert "$profile" -o "$work/lamp.gldf" -q
    product_of "$work/lamp.gldf"
    xmllint --noout --schema "$schema" "$work/product.xml" 2> "$work/said" || { cat "$work/said"; failed=1; }
    "$gonio" check --strict "$work/lamp.gldf" --json -q | grep -q '"GLD0[12]' && { echo "$profile: gonio finds fault with it"; failed=1; }
    written=$((written + 1))
done
echo "$written GLDF written"

for file in "$@"; do
    valid=yes
    product_of "$file" 2> /dev/null || valid=no # has none
    [[ $valid == no ]] || xmllint --noout --schema "$schema" "$work/product.xml" 2> "$work/said" || valid=no
    status=0
    "$gonio" check "$file" -q > "$work/check" || status=$?
    printf '%s: valid %s, ' "$file" "$valid"
    cut -d: -f2- "$work/check"
    if [[ $valid == yes ]] && ((status > 1)); then failed=1; fi
done
exit "$failed"
