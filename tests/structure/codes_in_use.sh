#!/usr/bin/env bash
# Finds diagnostic codes that are never reported. The compiler ensures that the source uses no unknown codes.
#
#   codes_in_use.sh ROOT
#
# The general code of a failure, the first of its family, does not appear in the source: fail(Failure::usage, …).
set -euo pipefail

cd "${1:?"usage: codes_in_use.sh ROOT"}"
tables=lib/gonio/base/codes
mapfile -t codes < <(grep -rhoE '^    \{"[A-Z][A-Z0-9]{2}[0-9]{4}"' "$tables" | grep -oE '[A-Z][A-Z0-9]{2}[0-9]{4}')
((${#codes[@]})) || { echo "no code in $tables"; exit 1; }
used=$(grep -rhoE --include='*.cpp' --include='*.hpp' --exclude-dir=codes '"[A-Z][A-Z0-9]{2}[0-9]{4}"' lib cli | sort -u)
unused=0
for code in "${codes[@]}"; do
    [[ $code =~ ^(USE|FIL|INP|UNS|INT)0101$ || $used == *"\"$code\""* ]] && continue
    echo "nothing says $code"
    unused=1
done
((unused == 0)) || exit 1
echo "${#codes[@]} codes are said"
