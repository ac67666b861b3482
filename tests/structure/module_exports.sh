#!/usr/bin/env bash
# Checks that a media module exports its one function and nothing else.   module_exports.sh MODULE FUNCTION
set -euo pipefail
module=${1:?"usage: module_exports.sh MODULE FUNCTION"}
function=${2:?"usage: module_exports.sh MODULE FUNCTION"}
exports=$(nm -D --defined-only --format=posix "$module" | cut -d' ' -f1)
if [[ $exports != "$function" ]]; then
    printf '%s exports, instead of %s alone:\n%s\n' "$module" "$function" "$exports"
    exit 1
fi
if readelf -d "$module" | grep -E 'NEEDED.*(libfmt|libgonio)'; then
    echo "$module links the above"
    exit 1
fi
echo "$module exports $function alone"
