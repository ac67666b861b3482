#!/usr/bin/env bash
# Checks that man and mandoc find nothing to complain about in manual pages.   check_manual_pages.sh FOLDER
set -euo pipefail

folder=${1:?"usage: check_manual_pages.sh FOLDER"}
for tool in man mandoc; do
    command -v "$tool" > /dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
shopt -s nullglob
pages=("$folder"/*.1)
((${#pages[@]})) || { echo "no page in $folder" >&2; exit 1; }
complaints=0
for page in "${pages[@]}"; do
    # As Debian's lintian calls it. man ends with 0 whatever it finds.
    said=$(LC_ALL=C.UTF-8 MANROFFSEQ='' MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z "$page" 2>&1 > /dev/null) || true
    said+=$(mandoc -T lint "$page") || true
    [[ -z $said ]] || { printf '%s: %s\n' "$page" "$said"; complaints=1; }
done
((!complaints)) || exit 1
echo "${#pages[@]} pages without a complaint"
