#!/usr/bin/env bash
# Checks that the first block of C++ in a page is the program, except for the program's first line.
#
#   tests/consumer/check_example.sh PAGE PROGRAM
set -euo pipefail

# shellcheck disable=SC2016 # the marks of Markdown are no command
diff <(sed -n '/^```cpp$/,/^```$/{ /^```/d; p }' "$1") <(tail -n +2 "$2")
