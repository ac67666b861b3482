// Noise determined by a number: the same on every thread and in every run.
#pragma once

#include <cstdint>

namespace gonio::detail {

// In [0, 1), computed from the bits of a seed (the finalizer of MurmurHash3, A. Appleby).
inline double unit_hash(std::uint32_t seed) {
    seed ^= seed >> 16U;
    seed *= 0x85ebca6bU;
    seed ^= seed >> 13U;
    seed *= 0xc2b2ae35U;
    seed ^= seed >> 16U;
    return seed * 0x1p-32;
}

} // namespace gonio::detail
