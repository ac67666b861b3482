#!/usr/bin/env bash
# Compiles and runs a program with what pkg-config says of the installed library.
#
#   check_pkg_config.sh COMPILER PKGCONFIG_FOLDER PROGRAM PROFILE
set -euo pipefail

compiler=${1:?"usage: check_pkg_config.sh COMPILER PKGCONFIG_FOLDER PROGRAM PROFILE"}
folder=$2 program=$3 profile=$4
export PKG_CONFIG_PATH=$folder
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

[[ -f $(pkg-config --variable=modules gonio)/gonio-image.so ]] || { echo 'the variable modules names no modules' >&2; exit 1; }
read -ra flags <<< "$(pkg-config --cflags gonio)"
read -ra libraries <<< "$(pkg-config --libs gonio)"
"$compiler" -std=c++20 "${flags[@]}" "$program" -o "$work/program" "${libraries[@]}"
# A shared object in a folder that the loader does not search.
LD_LIBRARY_PATH=$(pkg-config --variable=libdir gonio) "$work/program" "$profile" | tee "$work/said"
grep -q '^1200 lm, 3535.78 cd straight down' "$work/said"
