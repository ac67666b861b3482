#!/usr/bin/env bash
# Runs include_order.sh on trees with one fault each, and expects it to report the place.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failures=0

start() {
    rm -rf "${tree:?}/lib" "${tree:?}/cli"
    mkdir -p "$tree/lib/gonio/web/detail" "$tree/lib/gonio/base" "$tree/lib/gonio/media" "$tree/cli"
    printf '#pragma once\n#include <vector>\n' > "$tree/lib/gonio/base/image.hpp"
    printf '#include <gonio/base/image.hpp>\n// #include <gonio/media/module.hpp>\n' > "$tree/lib/gonio/web/web.cpp"
    printf '#include <fmt/format.h>\n' > "$tree/lib/gonio/web/detail/text.hpp"
    printf '#include <dlfcn.h>\n' > "$tree/lib/gonio/media/module.cpp"
    printf '#include <gonio/media/module.hpp>\n#include <CLI/CLI.hpp>\n' > "$tree/cli/main.cpp"
}

# fault FILE INCLUDE EXPECTED: one added include must be reported, at its line, with these words.
fault() {
    start
    mkdir -p "$tree/$(dirname "$1")"
    printf '\n%s\n' "$2" > "$tree/$1"
    local out
    if out=$("$here/include_order.sh" "$tree" 2>&1); then
        echo "not found: $2 in $1"
        failures=$((failures + 1))
    elif [[ $out != "$1:2: $3"* ]]; then
        printf 'wrong answer for %s in %s:\n%s\n' "$2" "$1" "$out"
        failures=$((failures + 1))
    fi
}

start
"$here/include_order.sh" "$tree" || { echo 'a faultless tree is refused'; failures=$((failures + 1)); }

fault lib/gonio/web/a.cpp '#include <gonio/light/light.hpp>' 'includes gonio/light/light.hpp: the room web stands before light'
fault lib/gonio/base/a.hpp '  #  include <gonio/web/web.hpp>' 'includes gonio/web/web.hpp: the room base stands before web'
fault lib/gonio/measure/a.cpp '#include <gonio/media/module.hpp>' 'includes gonio/media/module.hpp: the room measure stands before media'
fault lib/gonio/shading/a.hpp '#include <gonio/web/web.hpp>' 'includes gonio/web/web.hpp: shading is built on base'
fault lib/gonio/web/a.cpp '#include <gonio/base/detail/x.hpp>' 'includes gonio/base/detail/x.hpp: what is in detail/ belongs'
fault cli/a.cpp '#include <gonio/base/detail/x.hpp>' 'includes gonio/base/detail/x.hpp: it belongs to its room'
fault lib/gonio/web/a.cpp '#include <gonio/cellar/x.hpp>' 'includes gonio/cellar/x.hpp: there is no room cellar'
fault lib/gonio/web/a.cpp '#include <cli/options.hpp>' 'includes cli/options.hpp: the library knows'
fault lib/gonio/web/a.cpp '#include "../../../cli/options.hpp"' 'includes ../../../cli/options.hpp: no path'
fault cli/commands/a.cpp '#include "../../lib/gonio/web/web.hpp"' 'includes ../../lib/gonio/web/web.hpp: the include root'
fault lib/gonio/web/a.cpp '#include <CLI/CLI.hpp>' 'includes CLI/CLI.hpp: CLI11'
fault lib/gonio/web/a.hpp '#include <fmt/format.h>' 'includes fmt/format.h: a public header'
fault lib/gonio/web/a.hpp '#include <nlohmann/json.hpp>' 'includes nlohmann/json.hpp: a public header'
fault lib/gonio/web/a.hpp '#include <pugixml.hpp>' 'includes pugixml.hpp: a public header'
fault lib/gonio/web/a.cpp '#include <OpenImageIO/imageio.h>' 'includes OpenImageIO/imageio.h: OpenImageIO belongs'
fault lib/gonio/media/a.cpp '#include <OpenColorIO/OpenColorIO.h>' 'includes OpenColorIO/OpenColorIO.h: OpenColorIO belongs'
fault lib/gonio/media/a.cpp '#include <dlfcn.h>' 'includes dlfcn.h: dlopen stands'
fault lib/gonio/media/a.cpp '#include <cairo-pdf.h>' 'includes cairo-pdf.h: cairo and FreeType belong'
fault lib/gonio/web/a.cpp '#include <iostream>' 'includes <iostream>'
fault cli/a.cpp '#include <iostream>' 'includes <iostream>'
fault cli/a.cpp '#include <OpenImageIO/imageio.h>' 'includes OpenImageIO/imageio.h: OpenImageIO belongs'

# Two faults give two lines, and an unlisted room gives one.
start
mkdir -p "$tree/lib/gonio/attic"
printf '#include <vector>\n' > "$tree/lib/gonio/attic/a.cpp"
if "$here/include_order.sh" "$tree" > /dev/null; then
    echo 'an unknown room is let through'
    failures=$((failures + 1))
fi
((failures == 0)) && echo 'every fault was found'
exit $((failures > 0))
