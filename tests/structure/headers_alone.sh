#!/usr/bin/env bash
# Compiles every header of a list by itself: who includes one must not have to know what it needs.
#
#   headers_alone.sh INCLUDE_ROOT LIST COMPILER [FLAG…]     LIST: "gonio/base/text.hpp" a line
#
# Syntax only, without precompiled headers, as many at a time as there are processors. The intrinsics of another processor
# are left out. Prints what a compiler says, and fails when it says anything.
set -euo pipefail

root=${1:?"usage: headers_alone.sh INCLUDE_ROOT LIST COMPILER [FLAG…]"}
list=${2:?"no list"}
compiler=${3:?"no compiler"}
shift 3
case $(uname -m) in
x86_64) foreign=native_neon ;;
aarch64) foreign=native_x86 ;;
*) foreign='native_(x86|neon)' ;;
esac
headers=$(grep . "$list" | grep -vE "/$foreign\.hpp$") || { echo "$list lists no header" >&2; exit 2; }

alone() { # HEADER COMPILER FLAG…
    local header=$1 said
    shift
    if said=$("$@" -x c++ - <<< "#include <$header>" 2>&1) && [[ -z $said ]]; then return 0; fi
    printf '%s does not compile by itself:\n%s\n' "$header" "$said"
    return 1
}
export -f alone
# shellcheck disable=SC2016 # the inner shell expands it
if ! xargs -P "$(nproc)" -I HEADER bash -c 'alone "$@"' _ HEADER "$compiler" -std=c++20 -fsyntax-only \
    -Wall -Wextra -I "$root" "$@" <<< "$headers"; then
    exit 1
fi
echo "$(wc -l <<< "$headers") headers compile by themselves"
