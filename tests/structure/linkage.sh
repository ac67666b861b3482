#!/usr/bin/env bash
# Checks that a program starts without OpenImageIO, OpenColorIO and cairo.
#
#   linkage.sh PROGRAM [ARGUMENT…]   fails when PROGRAM needs one, or when running it as given opens one
#
# What is printed is thrown away: a picture may go to standard output.
set -euo pipefail

program=${1:?"usage: linkage.sh PROGRAM [ARGUMENT…]"}
shift
heavy='OpenImageIO|OpenColorIO|libcairo|libfreetype|gonio-(image|color|pdf)\.so'

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
echo "$program starts without OpenImageIO, OpenColorIO and cairo"
