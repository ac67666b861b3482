#!/usr/bin/env bash
# Cross-compiles the library for arm64 and runs the tests of its kernels under qemu-user: NEON against the scalar sets
# and double. Needs g++-aarch64-linux-gnu and qemu-user, and the packages that `bash tests/run.sh` installs.
#
#   bash tests/arm64/run.sh [GTEST_FILTER]
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
for tool in aarch64-linux-gnu-g++ qemu-aarch64; do
    command -v "$tool" > /dev/null || { echo "$tool is missing: apt-get install g++-aarch64-linux-gnu qemu-user" >&2; exit 2; }
done
[[ -d /usr/src/googletest/googletest ]] || { echo 'the source of GoogleTest is missing: apt-get install libgtest-dev' >&2; exit 2; }

build=build/arm64
# The headers of libraries are the same on every machine; the C library's headers come with the cross compiler.
headers='-idirafter /usr/include'
host=$(g++ -print-multiarch)
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF -DGONIO_MODULES=OFF \
    -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ \
    "-DCMAKE_CXX_FLAGS=$headers" "-DCMAKE_PREFIX_PATH=/usr/lib/$host/cmake;/usr/share" > /dev/null
cmake --build "$build" --parallel "$(nproc)" --target gonio gonio-measure

# The tests of code that is compiled for an instruction set, and of the arithmetic below it.
tests=(simd/dispatch_test simd/math_test shading/kernels_test shading/area_kernels_test shading/ellipse_test shading/light_shares_test
    bake/skip color/locus transport/part_links preview/materials preview/render)
compile() { # SOURCE OBJECT
    aarch64-linux-gnu-g++ -std=c++20 -O1 -ffp-contract=off -fno-math-errno -fno-tree-slp-vectorize -idirafter /usr/include \
        -I lib -I tests/unit -I tests/unit/shading -I /usr/src/googletest/googletest -c "$1" -o "$2"
}
export -f compile
mkdir -p "$build/tests"
sources=(/usr/src/googletest/googletest/src/gtest-all.cc /usr/src/googletest/googletest/src/gtest_main.cc)
for test in "${tests[@]}"; do sources+=("tests/unit/$test.cpp"); done
objects=()
jobs=()
for source in "${sources[@]}"; do
    object=$build/tests/$(basename "${source%.*}").o
    objects+=("$object")
    jobs+=("$source" "$object")
done
# shellcheck disable=SC2016 # the shell that xargs starts expands it
printf '%s\0' "${jobs[@]}" | xargs -0 -n 2 -P "$(nproc)" bash -c 'set -euo pipefail; compile "$1" "$2"' _
# Reading TM-33 needs pugixml, of which there is no library to link against here; no test reads it.
aarch64-linux-gnu-g++ -static -Wl,--unresolved-symbols=ignore-all -o "$build/tests/kernels" "${objects[@]}" \
    "$build/lib/gonio/measure/libgonio-measure.a" "$build/lib/libgonio.a" -lpthread

qemu-aarch64 "$build/tests/kernels" --gtest_brief=1 "--gtest_filter=${1:-*}"
