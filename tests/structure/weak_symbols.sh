#!/usr/bin/env bash
# Finds symbols that could bring one instruction set's code into another's.
#
#   weak_symbols.sh BUILD_FOLDER
#
# An inline function or template that is compiled into kernels_avx2.cpp.o and into another object is weak in both, and
# the linker keeps either: code with AVX may then run on a machine without it. So those objects may contain no weak or
# unique symbol except gonio's own that have their instruction set's tag type in their name. Fails if an object has
# another one, and if there is no such object at all.
set -euo pipefail

build=${1:?"usage: weak_symbols.sh BUILD_FOLDER"}
failures=0
objects=0
symbols=0
while IFS= read -r -d '' object; do
    # kernels_avx2.cpp.o, kernels_math_avx2.cpp.o
    [[ ${object##*/} =~ _(sse2|avx2|avx512|neon)[^a-z0-9] ]]
    tag=${BASH_REMATCH[1]}
    objects=$((objects + 1))
    while read -r type symbol; do
        [[ $type == [WVuwv] ]] || continue
        # From the compiler, without vector code: the pointer to the personality routine, clang's call of
        # std::terminate.
        [[ $symbol == DW.ref.__gxx_personality_v0 || $symbol == __clang_call_terminate ]] && continue
        symbols=$((symbols + 1))
        # _ZN5gonio…, and the guards, tables and local statics with such names.
        if [[ ! $symbol =~ ^_Z(GV|GR|T[VITS]|Z)*N[KVRO]*5gonio || $symbol != *"${#tag}$tag"* ]]; then
            printf '%s: %s %s\n' "$object" "$type" "$(c++filt "$symbol")"
            failures=$((failures + 1))
        fi
    done < <(nm --defined-only --format=posix "$object" | awk '{ print $2, $1 }')
done < <(find "$build" -type f -regextype posix-extended \
    -regex '.*/kernels_([a-z0-9_]+_)?(sse2|avx2|avx512|neon)[^a-z0-9][^/]*\.o' -print0 | LC_ALL=C sort -z)

if ((objects == 0)); then
    echo "no kernels_*.o of an instruction set under $build"
    exit 1
fi
if ((failures)); then
    echo "$failures symbols above are shared between instruction sets: give them the tag type, or internal linkage"
    exit 1
fi
echo "$symbols weak symbols of $objects objects carry their instruction set"
