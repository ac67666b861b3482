// The range of photometric amounts: values outside it are rejected on input, never clamped.
//
// One bound for intensities [cd], luminances [nt], illuminances [lx] and every number of a photometric file: the sun as
// a point has 3e27 cd. Textures, pictures and engines store light as 32-bit floats, which end at 3.4e38: above 1e30
// there is room for colours, solid angles and sums of many lights.
#pragma once

#include <cmath>

namespace gonio {

inline constexpr double greatest_amount = 1e30;

// False for NaN.
inline bool in_amount_range(double value) {
    return std::abs(value) <= greatest_amount;
}

} // namespace gonio
