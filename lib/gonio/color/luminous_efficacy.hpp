// The constant between watts and lumens.
#pragma once

namespace gonio {

// [lm/W], at 540 THz (SI). The maximum of V(λ), at 555 nm in air, is 683.002: a difference of 3e-6.
inline constexpr double luminous_efficacy_constant = 683.0;

} // namespace gonio
