// The range of photometric amounts: values beyond it are refused where they enter, and never clamped.
//
// One bound for intensities [cd], luminances [nt], illuminances [lx] and every number of a photometric file: as a
// point, the sun has 3e27 cd. Textures, pictures and engines hold light as 32-bit floats, which end at 3.4e38: above
// 1e30 there is room for colours, solid angles and sums of many lights.
#pragma once

#include <cmath>

namespace gonio {

inline constexpr double greatest_amount = 1e30;

// False for NaN.
inline bool in_amount_range(double value) {
    return std::abs(value) <= greatest_amount;
}

} // namespace gonio
