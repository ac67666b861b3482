#!/usr/bin/env bash
# Compiles every installed header separately, with no other headers of gonio available. Checks that what it declares is
# exported from the shared library.
#
#   check_headers.sh COMPILER INCLUDE_FOLDER
set -euo pipefail

compiler=${1:?"usage: check_headers.sh COMPILER INCLUDE_FOLDER"}
folder=${2:?"usage: check_headers.sh COMPILER INCLUDE_FOLDER"}

check() { # COMPILER FOLDER HEADER
    ! grep -q '^namespace gonio' "$2/$3" || [[ $(grep -cxE '#pragma GCC visibility (push\(default\)|pop)' "$2/$3") == 2 ]] ||
        { echo "$3 does not put its names between '#pragma GCC visibility push(default)' and '… pop'" >&2; return 1; }
    echo "#include <$3>" | "$1" -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I "$2" -x c++ - ||
        { echo "$3 does not compile by itself" >&2; return 1; }
}
export -f check

cd "$folder"
mapfile -t headers < <(find gonio -name '*.hpp' | LC_ALL=C sort)
((${#headers[@]})) || { echo "no header is installed in $folder" >&2; exit 1; }
# shellcheck disable=SC2016 # the shell that xargs starts expands it
printf '%s\0' "${headers[@]}" |
    xargs -0 -n 1 -P "$(nproc)" bash -c 'check "$1" "$2" "$3"' _ "$compiler" "$folder"
echo "${#headers[@]} headers compile by themselves"
