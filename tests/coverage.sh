#!/usr/bin/env bash
# How much of the library the tests run: builds tests and tool with clang's coverage into build/coverage, runs ctest,
# and prints the covered lines of each room of lib/, in total, and of each file below 80 %.
#
#   bash tests/coverage.sh              fails below 90 % in total, or when a test fails
#   bash tests/coverage.sh --report     prints again what the last run gave
#
# GONIO_COVERAGE_LEAST (90) is the limit. Kernels of instruction sets that this machine cannot run are left out, as are
# programs that generate committed data. Needs clang-14 and llvm-14.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build/coverage
least=${GONIO_COVERAGE_LEAST:-90}
failed=0

if [[ ${1:-} != --report ]]; then
    cmake --preset coverage > /dev/null
    cmake --build --preset coverage --parallel "$(nproc)"
    rm -rf "$build/profiles"
    # %m: one file for each program and module, which collects all its runs.
    export LLVM_PROFILE_FILE="$PWD/$build/profiles/%4m.profraw"
    # The limits that these tests set also apply to the files with the counts: the tests count, but may fail.
    limited='^(golden\.(bake-batch|outputs|overflow|pictures)|system\..*)$'
    # An installed archive with coverage counters does not link without clang's runtime.
    ctest --test-dir "$build" --parallel "$(nproc)" --output-on-failure --no-tests=error \
        -E "$limited|^consumer\." || failed=1
    ctest --test-dir "$build" --parallel "$(nproc)" -R "$limited" > /dev/null || true
    llvm-profdata-14 merge -sparse -o "$build/all.profdata" "$build"/profiles/*.profraw
fi

left_out='/fit/|kernels[a-z_]*_neon'
for set in avx2 avx512; do
    flag=$set
    [[ $set == avx512 ]] && flag=avx512f
    grep -qw "$flag" /proc/cpuinfo || left_out+="|kernels[a-z_]*_$set"
done

programs=("$build/tests/gonio-unit" -object "$build/tests/gonio-unit-threads")
for more in "$build/cli/gonio" "$build"/cli/gonio-*.so; do
    [[ -f $more ]] && programs+=(-object "$more")
done
llvm-cov-14 export -format=lcov -summary-only -instr-profile "$build/all.profdata" "${programs[@]}" |
    awk -F: -v root="$PWD/lib/gonio/" -v left_out="$left_out" -v least="$least" -v failed="$failed" '
        function share(hit, of) { return of ? 100 * hit / of : 100 }
        $1 == "SF" {
            sub(/\/build\/coverage\/\.\.\/\.\./, "", $2) # as ccache writes paths
            file = index($2, root) == 1 ? substr($2, length(root) + 1) : ""
        }
        file == "" || file ~ left_out { next }
        $1 == "LF" { lines[file] = $2 }
        $1 == "LH" { hit[file] = $2 }
        END {
            for (file in lines) {
                room = substr(file, 1, index(file, "/") - 1)
                of[room] += lines[file]; run[room] += hit[file]
                total += lines[file]; covered += hit[file]
                if (share(hit[file], lines[file]) < 80)
                    low[++lows] = sprintf("%6.1f %%  %5d lines not run  %s", share(hit[file], lines[file]),
                                          lines[file] - hit[file], file)
            }
            if (!total) { print "no line of lib/ was counted"; exit 1 }
            for (room in of)
                printf "%6.1f %%  %6d of %6d lines  %s\n", share(run[room], of[room]), run[room], of[room],
                    room | "sort -k6"
            close("sort -k6")
            printf "%6.1f %%  %6d of %6d lines  in total\n", share(covered, total), covered, total
            if (lows) print "\nbelow 80 %:"
            for (i = 1; i <= lows; ++i) print low[i] | "sort -n"
            close("sort -n")
            if (failed) print "\na test failed"
            if (share(covered, total) < least) printf "\nbelow %s %%\n", least
            exit failed || share(covered, total) < least
        }'
