#!/usr/bin/env bash
# Lights and stages as import and preview --export write them for Radiance, by its rtrace, against probe. Opt-in: needs
# oconv and rtrace of Radiance 5.3 or later in PATH, with their library in RAYPATH, and takes minutes.
#
#   bash tests/radiance/run.sh GONIO
set -euo pipefail

gonio=$(realpath "${1:?"usage: run.sh GONIO"}")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
for program in oconv rtrace; do
    command -v "$program" > /dev/null || { echo "$program of Radiance is not installed: skipped"; exit 0; }
done
work=$(dirname "$gonio")/../radiance-check
mkdir -p "$work"
cd "$work"
exec /usr/bin/python3 "$here/check.py" "$gonio"
