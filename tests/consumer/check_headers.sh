#!/usr/bin/env bash
# Compiles every installed header separately, with no other headers of gonio available. Checks that what it declares is
# exported from the shared library.
#
#   check_headers.sh COMPILER INCLUDE_FOLDER FOLDER [CCACHE]
#
# FOLDER receives what is compiled, which ccache then knows as long as nothing changes that a header includes.
set -euo pipefail

usage='usage: check_headers.sh COMPILER INCLUDE_FOLDER FOLDER [CCACHE]'
compiler=${1:?"$usage"}
folder=${2:?"$usage"}
work=${3:?"$usage"}
launcher=${4:-}

check() { # HEADER
    ! grep -q '^namespace gonio' "$1" || [[ $(grep -cxE '#pragma GCC visibility (push\(default\)|pop)' "$1") == 2 ]] ||
        { echo "$1 does not put its names between '#pragma GCC visibility push(default)' and '… pop'" >&2; return 1; }
    local source=$work/${1//\//_}
    source=${source%.hpp}.cpp
    echo "#include <$1>" > "$source"
    # shellcheck disable=SC2086 # the launcher may be empty
    $launcher "$compiler" -std=c++20 -Wall -Wextra -Werror -I "$folder" -MD -c "$source" -o "${source%.cpp}.o" ||
        { echo "$1 does not compile by itself" >&2; return 1; }
}
export -f check
export compiler folder work launcher
export CCACHE_DEPEND=1 # what is not known is read once, not twice

rm -rf "$work"
mkdir -p "$work"
cd "$folder"
mapfile -t headers < <(find gonio -name '*.hpp' | LC_ALL=C sort)
((${#headers[@]})) || { echo "no header is installed in $folder" >&2; exit 1; }
# shellcheck disable=SC2016 # the shell that xargs starts expands it
printf '%s\0' "${headers[@]}" |
    xargs -0 -n 1 -P "$(nproc)" bash -c 'check "$1"' _
echo "${#headers[@]} headers compile by themselves"
