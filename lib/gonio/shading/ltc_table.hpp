// Lobes as linearly transformed cosines, fitted by fit/ltc.cpp: the numbers behind ltc_lobe.hpp.
#pragma once

#include <array>
#include <cstddef>

namespace gonio::shading {

// One lobe in the frame x (towards which the mirrored view leans), y, z (the normal). With μ = n·v and s = √(1 − μ²)
// the inverse of its matrix, times α (for the diffuse part: times 1), is
//
//     ( along·μ + raised·s²   0        (raised·μ − along)·s )
//     ( 0                     across   0                    )
//     ( α·slant·s             0        α                    )
//
// Aligned so that the numbers of an entry fill one register of eight floats.
struct alignas(32) LtcEntry {
    float along, raised, across, slant;
    float albedo;  // directional albedo for F = 1
    float grazing; // the same for F = (1 − l·h)⁵
};

// Rows by √μ and columns by √α (GGX) or the linear roughness (renormalised Disney diffuse), both from 0 to 1.
inline constexpr std::size_t ltc_ggx_size = 32;
inline constexpr std::size_t ltc_diffuse_size = 12;
extern const std::array<LtcEntry, ltc_ggx_size * ltc_ggx_size> ltc_ggx_table;
extern const std::array<LtcEntry, ltc_diffuse_size * ltc_diffuse_size> ltc_diffuse_table;

} // namespace gonio::shading
