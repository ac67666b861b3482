#!/usr/bin/env bash
# Builds the library for WebAssembly on Debian 12: installs missing packages, gets the source of pugixml, of which Debian
# has no WebAssembly archive, and runs the preset `wasm`. Arguments go to the configuring CMake.
#
#   bash lib/wasm/build.sh                        build/wasm/lib/libgonio.a
#   bash lib/wasm/build.sh -DGONIO_WASM_SIMD=OFF  for browsers without SIMD
#
# GONIO_PUGIXML_SOURCE names a folder of pugixml.cpp that is already there. GONIO_WASM_TARGETS (gonio) is what is built.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
bash cli/install-dependencies.sh --wasm

pugixml=${GONIO_PUGIXML_SOURCE:-}
if [[ -z $pugixml ]]; then
    folder=$root/build/pugixml
    pugixml=$folder/src
    if [[ ! -f $pugixml/pugixml.cpp ]]; then
        mkdir -p "$folder/lists/partial" "$pugixml"
        # The sources of the archive that the system's packages come from; the system's own lists stay as they are.
        # shellcheck disable=SC2016 # apt expands it
        apt-get indextargets --format 'deb-src $(REPO_URI) $(CODENAME) $(COMPONENT)' 'Created-By: Packages' |
            grep ' main$' | sort -u > "$folder/sources.list"
        apt=(apt-get -qq -o "Dir::Etc::SourceList=$folder/sources.list" -o Dir::Etc::SourceParts=/dev/null
            -o "Dir::State::Lists=$folder/lists" -o APT::Sandbox::User=root)
        "${apt[@]}" update >&2
        (cd "$folder" && "${apt[@]}" source --download-only pugixml >&2)
        tar -xf "$folder"/pugixml_*.orig.tar.* --directory "$pugixml" --strip-components 2 --wildcards '*/src/*'
    fi
fi

# The linker's JavaScript parser is a package of Debian, which a Node from elsewhere does not find.
if [[ -d /usr/share/nodejs/acorn ]]; then export NODE_PATH=/usr/share/nodejs${NODE_PATH:+:$NODE_PATH}; fi
cmake --preset wasm "-DGONIO_PUGIXML_SOURCE=$pugixml" "$@" > /dev/null
read -ra targets <<< "${GONIO_WASM_TARGETS:-gonio}"
cmake --build --preset wasm --parallel "$(nproc)" --target "${targets[@]}"
