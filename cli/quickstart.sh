#!/usr/bin/env bash
# From a fresh checkout on Debian 12 to a first picture: installs what is missing, builds the tool, lights a floor.
#
#   cli/quickstart.sh [OUT.png]
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/quickstart
out=${1:-$build/quickstart.png}

bash "$root/cli/install-dependencies.sh"

# ccache only where the caller asked for it: a first build has nothing to gain from it.
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF > /dev/null
cmake --build "$build"

gonio=$build/cli/gonio
"$gonio" preview "$root/profiles/downlight.ies" --stage floor -s 640x480 -o "$out"

cat << TEXT

The picture: $out
The tool:    $gonio

What to do next:
  $gonio info $root/profiles/downlight.ies           # flux, peak, beam and field angle
  $gonio units 800lm --shape sphere:r=3cm --to cd,nt # photometric units of a shape
  $gonio help                                        # every command
  sudo cmake --install $build                        # into /usr/local
TEXT
