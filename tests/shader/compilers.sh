#!/usr/bin/env bash
# Compiles every shader that gonio-shader-cases wrote into FOLDER, and counts instructions.
#
#   bash tests/shader/compilers.sh FOLDER
#
# GLSL and HLSL by glslang, their SPIR-V by spirv-val; the SPIR-V of GLSL 4.50 goes on to MSL and back to GLSL by
# spirv-cross. The MSL that gonio prints is compiled by g++ with a stand-in for Metal's library, which checks syntax and
# types; Apple's compiler runs on macOS only. WGSL is checked in the browser (browser.mjs), whose compiler is tint. OSL
# is compiled by oslc where there is one: $GONIO_OSLC, or in the path; Debian has none.
# FOLDER/instructions.txt gets a line for each function: its name, then the instructions of its whole shader after
# spirv-opt -O, with early returns, with selects, and of the one written by hand if there is one.
set -euo pipefail

folder=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
log=$folder/compiler.log
failed=0
passed=0

# check WHAT COMMAND…
check() {
    local what=$1
    shift
    if "$@" >"$log" 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "$what:"
        head -20 "$log"
    fi
}

instructions() {
    spirv-opt -O "$1" -o "$folder/optimised.spv"
    spirv-dis --raw-id "$folder/optimised.spv" | awk '
        /OpFunction / { inside = 1 }
        inside && !/OpFunction|OpLabel|OpFunctionEnd|OpVariable|OpName/ { ++count }
        END { print count + 0 }'
}

for shader in "$folder"/glsl-es300/*.frag; do
    check "$shader" glslangValidator "$shader"
done
for shader in "$folder"/hlsl/*.hlsl; do
    check "$shader" glslangValidator -D -V -S frag -e main "$shader" -o "${shader%.hlsl}.spv"
    check "$shader, spirv-val" spirv-val "${shader%.hlsl}.spv"
done
for shader in "$folder"/msl/*.metal; do
    check "$shader" g++ -std=c++14 -x c++ -fsyntax-only -Wall -Werror -I "$here/metal" "$shader"
done
oslc=${GONIO_OSLC:-$(command -v oslc || true)}
if [[ -n $oslc ]]; then
    for shader in "$folder"/osl/*.osl; do
        check "$shader" "$oslc" -q -o "${shader%.osl}.oso" "$shader"
    done
else
    echo "there is no oslc: $(find "$folder/osl" -name '*.osl' | wc -l) shaders in OSL were not compiled"
fi
for shader in "$folder"/glsl450/*.frag; do
    spirv=${shader%.frag}.spv
    check "$shader" glslangValidator -V --target-env vulkan1.1 "$shader" -o "$spirv"
    check "$shader, spirv-val" spirv-val "$spirv"
    check "$shader, to MSL" spirv-cross --msl "$spirv" --output "${shader%.frag}.cross.metal"
    check "$shader, to GLSL" spirv-cross --version 450 --vulkan-semantics "$spirv" --output "${shader%.frag}.cross.frag"
    check "$shader, and back" glslangValidator -V --target-env vulkan1.1 "${shader%.frag}.cross.frag" -o "$folder/back.spv"
done
: >"$folder/instructions.txt"
for spirv in "$folder"/glsl450/*.real.spv; do
    name=$(basename "$spirv" .real.spv)
    counts="$(instructions "$spirv") $(instructions "$folder/glsl450/$name.select.spv")"
    by_hand=$folder/glsl450/$name.hand.spv
    [[ ! -e $by_hand ]] || counts+=" $(instructions "$by_hand")"
    echo "$name $counts" >>"$folder/instructions.txt"
done
echo "$passed compilations passed, $failed failed"
((failed == 0))
