#!/usr/bin/env bash
# Compiles the example of cli/shader/ENGINES.md with what the tool prints for it: GLSL by glslang, the SPIR-V by spirv-val,
# and on to MSL and back to GLSL by spirv-cross.
#
#   bash tests/shader/include.sh GONIO
set -euo pipefail

gonio=$(realpath "${1:?"usage: include.sh GONIO"}")
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# The command of the page itself.
command=$(grep -oP '^\$ gonio \Kshader .*-o area_lights\.glsl$' "$root/cli/shader/ENGINES.md")
read -ra words <<< "$command"
(cd "$work" && "$gonio" "${words[@]}")
glslangValidator -V --target-env vulkan1.1 "-I$work" "$root/cli/shader/example/area_lights.frag" -o "$work/example.spv"
spirv-val "$work/example.spv"
spirv-cross --msl "$work/example.spv" --output "$work/example.metal"
spirv-cross --version 450 --vulkan-semantics "$work/example.spv" --output "$work/example.frag"
glslangValidator -V --target-env vulkan1.1 "$work/example.frag" -o "$work/back.spv" > /dev/null
spirv-opt -O "$work/example.spv" -o "$work/optimised.spv"
echo "the example compiles: $(stat --format %s "$work/optimised.spv") bytes of optimised SPIR-V"
