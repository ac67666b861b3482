#!/usr/bin/env bash
# The check of codes must find faults: a code that no source uses, and a tree without codes.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder"/lib/gonio/base/codes "$folder"/cli
table=$folder/lib/gonio/base/codes/web.hpp

printf '    {"USE0101", …},\n    {"WEB0101", …},\n' > "$table"
printf 'add("WEB0101");\n' > "$folder/cli/check.cpp"
bash "$here/codes_in_use.sh" "$folder" > /dev/null || { echo 'codes that are said are refused'; exit 1; }
printf '    {"WEB0102", …},\n' >> "$table"
if said=$(bash "$here/codes_in_use.sh" "$folder"); then echo 'a code that nothing says passes'; exit 1; fi
[[ $said == 'nothing says WEB0102' ]] || { echo "it says: $said"; exit 1; }
: > "$table"
if bash "$here/codes_in_use.sh" "$folder" > /dev/null; then echo 'a tree without codes passes'; exit 1; fi
