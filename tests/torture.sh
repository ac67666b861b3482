#!/usr/bin/env bash
# Misuses the tool for a while and checks the result: hostile inputs, full disks, closed descriptors, signals, limits,
# several writers at once.
#
#   bash tests/torture.sh GONIO [SECONDS] [--seed N] [--only KIND[:CASE]] [--keep DIR]
#
# SECONDS (600) is the time for all kinds together. Prints what was run and what went wrong, by kind, and the first case
# of each fault as a command with its files kept in DIR (build/torture). The same seed gives the same cases, except for
# the moments at which signals arrive. Exits 1 if there was a fault. A tmpfs is mounted if that is allowed; needs only
# Python 3.
set -euo pipefail
exec python3 "$(dirname "${BASH_SOURCE[0]}")/torture/torture.py" "$@"
