#!/usr/bin/env bash
# Checks that every coefficient printed by the fit is in the header.
#
#   tests/generated/minimax.sh PROGRAM HEADER
set -euo pipefail

count=0
while read -r coefficient; do
    grep -qF -- "$coefficient" "$2" || { echo "$2 lacks $coefficient"; exit 1; }
    count=$((count + 1))
done < <("$1" | sed 's/.*: //' | grep -oE -- '-?[0-9.]+(e[-+]?[0-9]+)?F')
((count > 30)) || { echo "only $count coefficients were printed"; exit 1; }
