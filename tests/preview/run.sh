#!/usr/bin/env bash
# The same scene in Blender's Cycles and in gonio's preview: planes and a ball under two profiles, a sphere and a
# rectangle. Opt-in: needs Blender and python3-openimageio, takes a minute.
#
#   bash tests/preview/run.sh GONIO
set -euo pipefail

gonio=$(realpath "${1:?"usage: run.sh GONIO"}")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

command -v blender > /dev/null || { echo 'Blender is not installed: skipped'; exit 0; }
mkdir lights
"$gonio" import "$here/scene.json" --to blender -O lights -q
"$gonio" preview --rig "$here/scene.json" -s 128x96 --look falsecolour -o lux.exr
blender --background --factory-startup --python "$here/blender_scene.py" -- \
    "$here/scene.json" lights/blender/scene.py "$work/blender.exr" 128 96 1024 > blender.log 2>&1 ||
    { tail -n 40 blender.log; exit 1; }
/usr/bin/python3 "$here/compare_pictures.py" blender.exr lux.exr
