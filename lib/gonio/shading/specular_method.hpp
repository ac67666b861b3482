// Methods for the specular luminance of an area light, by name.
#pragma once

#include <cstdint>

namespace gonio::shading {

// ltc is in specular_ltc.hpp; the others, kept for comparison, are in specular_named.hpp.
enum class SpecularMethod : std::uint8_t {
    ltc,
    representative_point,
    dominant_direction,
    specular_d,
    spherical_hack,
    sun_disk
};

// The default method.
inline constexpr SpecularMethod standard_specular_method = SpecularMethod::ltc;

// Luminance towards the eye per luminance of the light is scale·(f0 + (f90 − f0)·grazing); scale is for F = 1.
template<class S>
struct SpecularLuminance {
    S scale, grazing;
};

} // namespace gonio::shading
