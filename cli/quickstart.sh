#!/usr/bin/env bash
# From a fresh checkout on Debian 12 to a first picture: installs missing packages, builds the tool, lights a floor.
#
#   cli/quickstart.sh [OUT.png]
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release
out=${1:-$build/quickstart.png}

bash "$root/cli/install-dependencies.sh"

# The build folder of tests/run.sh, which continues from this build. A configured folder is left as it is.
cd "$root"
[[ -f $build/build.ninja ]] || cmake --preset release -DBUILD_TESTING=OFF > /dev/null
cmake --build --preset release --target gonio-tool

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
