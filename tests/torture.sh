#!/usr/bin/env bash
# Treats the tool badly for a while and looks at what is left: hostile inputs, full disks, closed descriptors, signals,
# limits, several writers at once.
#
#   bash tests/torture.sh GONIO [SECONDS] [--seed N] [--only KIND[:CASE]] [--keep DIR]
#
# SECONDS (600) is the time of all kinds together. It prints what was run and what was wrong, by kind, and the first
# case of each fault as a command with its files kept in DIR (build/torture). The same seed gives the same cases, but
# for where signals hit. Exits 1 when there was a fault. A tmpfs is mounted where that is allowed; needs Python 3 only.
set -euo pipefail
exec python3 "$(dirname "${BASH_SOURCE[0]}")/torture/torture.py" "$@"
