#!/usr/bin/env bash
# Builds the library for WebAssembly on Debian 12: installs missing packages, gets the source of pugixml, of which Debian
# has no WebAssembly archive, and runs the preset `wasm`. Arguments go to the configuring CMake.
#
#   bash lib/wasm/build.sh                        build/wasm/lib/libgonio.a
#   bash lib/wasm/build.sh -DGONIO_WASM_SIMD=OFF  build/wasm-no-simd/lib/libgonio.a, for engines without SIMD
#
# GONIO_WASM_BUILD names another folder to build in. GONIO_PUGIXML_SOURCE names a folder of pugixml.cpp that is already there.
# GONIO_WASM_TARGETS (gonio) is what is
# built, GONIO_JOBS (one for each processor) how many compilers run.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
bash cli/install-dependencies.sh --wasm

# The folder of a library's source: the environment names it, or it is that of the system's package, whose FILES are
# unpacked without the first STRIP folders of their paths.
source_of() { # VARIABLE PACKAGE STRIP FILES
    local given=${!1:-} package=$2 strip=$3 files=$4
    local sources=$root/build/sources
    if [[ -n $given ]]; then echo "$given"; return; fi
    if [[ ! -d $sources/$package ]]; then
        mkdir -p "$sources/lists/partial" "$sources/unpacked"
        # The sources of the release itself: the archives of updates do not keep theirs. The system's own lists stay as they
        # are.
        # shellcheck disable=SC2016 # apt expands it
        apt-get indextargets --format 'deb-src $(REPO_URI) $(CODENAME) $(COMPONENT)' 'Created-By: Packages' |
            grep -E ' [a-z]+ main$' | sort -u > "$sources/sources.list"
        local apt=(apt-get -qq -o "Dir::Etc::SourceList=$sources/sources.list" -o Dir::Etc::SourceParts=/dev/null
            -o "Dir::State::Lists=$sources/lists" -o APT::Sandbox::User=root)
        "${apt[@]}" update >&2
        (cd "$sources" && "${apt[@]}" source --download-only "$package" >&2)
        tar -xf "$sources/$package"_*.orig.tar.?z* --directory "$sources/unpacked" --strip-components "$strip" \
            --wildcards "$files"
        mv "$sources/unpacked" "$sources/$package"
    fi
    echo "$sources/$package"
}
pugixml=$(source_of GONIO_PUGIXML_SOURCE pugixml 2 '*/src/*')
zlib=$(source_of GONIO_ZLIB_SOURCE zlib 1 '*')
libpng=$(source_of GONIO_LIBPNG_SOURCE libpng1.6 1 '*')

# The linker's JavaScript parser is a package of Debian, which a Node from elsewhere does not find.
if [[ -d /usr/share/nodejs/acorn ]]; then export NODE_PATH=/usr/share/nodejs${NODE_PATH:+:$NODE_PATH}; fi
folder=build/wasm
for word in "$@"; do
    if [[ $word == -DGONIO_WASM_SIMD=OFF ]]; then folder=build/wasm-no-simd; fi
done
folder=${GONIO_WASM_BUILD:-$folder}
configure() { # FOLDER OPTIONS
    cmake --preset wasm -B "$1" "-DGONIO_PUGIXML_SOURCE=$pugixml" "-DGONIO_ZLIB_SOURCE=$zlib" "-DGONIO_LIBPNG_SOURCE=$libpng" \
        "${@:2}" > /dev/null
}
read -ra targets <<< "${GONIO_WASM_TARGETS:-gonio}"
build() { # FOLDER TARGET…
    cmake --build "$1" --parallel "${GONIO_JOBS:-$(nproc)}" --target "${@:2}"
}
# Each kind in a folder of its own, since all of it is compiled otherwise: the module of profiles, the modules with the tool, and
# what is no module.
tool_modules=()
others=()
for target in "${targets[@]}"; do
    case $target in
        gonio-core-module)
            configure "$folder-small" -DGONIO_WASM_SMALL=ON "$@"
            build "$folder-small" "$target"
            mkdir -p "$folder"
            cp "$folder-small/gonio-core.mjs" "$folder"
            ;;
        gonio-module | gonio-page-module) tool_modules+=("$target") ;;
        *) others+=("$target") ;;
    esac
done
if ((${#tool_modules[@]} > 0)); then
    configure "$folder-modules" -DGONIO_WASM_LTO=ON "$@"
    build "$folder-modules" "${tool_modules[@]}"
    mkdir -p "$folder"
    for target in "${tool_modules[@]}"; do
        cp "$folder-modules/${target%-module}.mjs" "$folder"
    done
fi
if ((${#others[@]} > 0)); then
    configure "$folder" "$@"
    build "$folder" "${others[@]}"
fi
