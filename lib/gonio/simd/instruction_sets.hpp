// The instruction sets, as types; a pack is as wide as their registers.
#pragma once

#include <cstddef>

namespace gonio::simd {

struct sse2 {
    static constexpr std::size_t lanes = 4;
};
struct avx2 {
    static constexpr std::size_t lanes = 8;
};
struct avx512 {
    static constexpr std::size_t lanes = 16;
};
struct neon {
    static constexpr std::size_t lanes = 4;
};
struct wasm128 {
    static constexpr std::size_t lanes = 4;
};

// The operations of a set that vector extensions do not offer: native.hpp, which only files for one set include. The
// intrinsics are long headers.
template<class Isa>
struct Native;

} // namespace gonio::simd
