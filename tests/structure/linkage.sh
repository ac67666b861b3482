#!/usr/bin/env bash
# Checks that a program starts without OpenImageIO and OpenColorIO.
#
#   linkage.sh PROGRAM [ARGUMENT…]   fails when PROGRAM needs either, or when running it as given opens either
#
# What is printed is thrown away: a picture may go to standard output.
set -euo pipefail

program=${1:?"usage: linkage.sh PROGRAM [ARGUMENT…]"}
shift
heavy='OpenImageIO|OpenColorIO|gonio-(image|color)\.so'

needed=$(ldd "$program")
if grep -E "$heavy" <<< "$needed"; then
    echo "$program links the above"
    exit 1
fi
if (($#)); then
    opened=$(LD_DEBUG=files "$program" "$@" 2>&1 > /dev/null) || { echo "$program $* failed"; exit 1; }
    if grep -E "calling init: .*($heavy)" <<< "$opened"; then
        echo "$program $* opens the above"
        exit 1
    fi
fi
echo "$program starts without OpenImageIO and OpenColorIO"
