#!/usr/bin/env bash
# Runs weak_symbols.sh on objects with and without a fault.   weak_symbols_self_test.sh COMPILER
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
compiler=${1:?"usage: weak_symbols_self_test.sh COMPILER"}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# object NAME < source
object() {
    rm -f "$work"/*.o
    "$compiler" -std=c++20 -O0 -x c++ -c - -o "$work/$1"
}
expect() { # expect pass|fail WHAT [WORDS]
    local out status=0
    out=$("$here/weak_symbols.sh" "$work" 2>&1) || status=$?
    if [[ $1 == pass && $status != 0 || $1 == fail && $status == 0 || $out != *"${3:-}"* ]]; then
        printf '%s: expected to %s, status %s:\n%s\n' "$2" "$1" "$status" "$out"
        failures=$((failures + 1))
    fi
}

expect fail 'no object' 'no kernels_'

object kernels_avx2.cpp.o << 'CODE'
namespace gonio::simd { struct avx2 {}; }
namespace gonio::shading {
template<class Isa> struct Pack { float v; Pack twice() const { return {v + v}; } };
template<class Isa> float f(float x) { static float last = x; return last = Pack<Isa>{x}.twice().v; }
float avx2_entry(float x) { return f<simd::avx2>(x); }
}
CODE
expect pass 'tagged templates' ' weak symbols of 1 objects'

object kernels_avx2.cpp.o << 'CODE'
namespace gonio::simd { struct avx2 {}; }
namespace gonio { inline float shared(float x) { return x + x; } float entry(float x) { return shared(x); } }
CODE
expect fail 'an untagged inline function' 'gonio::shared(float)'

object kernels_math_avx512.cpp.o << 'CODE'
namespace gonio::simd { struct avx2 {}; }
namespace gonio { template<class I> float f(float x) { return x; } float e(float x) { return f<simd::avx2>(x); } }
CODE
expect fail 'the tag of another instruction set' 'gonio::simd::avx2'

object kernels_sse2_extra.cpp.o << 'CODE'
#include <vector>
namespace gonio { struct sse2 {}; std::vector<int> entry(int n) { return std::vector<int>(static_cast<unsigned>(n)); } }
CODE
expect fail 'a template of the standard library' 'std::vector'

((failures == 0)) && echo 'every fault was found'
exit $((failures > 0))
