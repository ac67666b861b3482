#!/usr/bin/env bash
# Builds and runs a program that has gonio as a part of its own project: fetched from this repository with FetchContent,
# and as a folder with add_subdirectory. The fetched one is the last commit.
#
#   tests/package/subprojects.sh
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
commit=$(git -C "$root" rev-parse HEAD)

build() { # NAME OPTION…
    local name=$1
    shift
    cmake -G Ninja -S "$root/tests/consumer/subproject" -B "$work/$name" -DCMAKE_BUILD_TYPE=Release "$@" > /dev/null
    cmake --build "$work/$name" --parallel "$(nproc)" --target host gonio-image gonio-writers gonio-color gonio-pdf | tail -n 1
    "$work/$name/host"
    echo "$name works"
}
build FetchContent "-DGONIO_FETCH=GIT_REPOSITORY;file://$root;GIT_TAG;$commit"
build add_subdirectory "-DGONIO_SOURCE=$root"
