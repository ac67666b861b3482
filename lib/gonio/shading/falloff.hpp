// Falloff with distance: the inverse square, and the windows that bring it to zero at a range.
//
// A window is an error budget, not physics: against I/d² it takes away at most 1.0887·I/r² (squared, at 0.904 r) or
// I/r² (glTF, at r), in lux for I in candela and r in metres. The guards of renderers against d → 0 are not here.
#pragma once

#include <gonio/simd/pack.hpp>

namespace gonio::shading {

// ⟨1 − (d/r)⁴⟩², of Frostbite and Unreal Engine 4 (B. Karis, "Real Shading in Unreal Engine 4", 2013). In [0, 1].
// inverse_range = 1/r ≥ 0; 0 gives 1.
template<class S>
GONIO_FORCE_INLINE S window_squared(S distance, S inverse_range) {
    const S x = distance * inverse_range;
    const S x2 = x * x;
    const S w = simd::max(S(1) - x2 * x2, S(0));
    return w * w;
}

// max(min(1 − (d/r)⁴, 1), 0), of KHR_lights_punctual. In [0, 1].
template<class S>
GONIO_FORCE_INLINE S window_gltf(S distance, S inverse_range) {
    const S x = distance * inverse_range;
    const S x2 = x * x;
    return simd::max(S(1) - x2 * x2, S(0));
}

// The range r [m] whose squared window leaves I/r² = `threshold_lx` at its edge: r = √(I/E).
template<class S>
GONIO_FORCE_INLINE S range_of_threshold(S intensity_cd, S threshold_lx) {
    return simd::sqrt(intensity_cd / threshold_lx);
}

// Factor of Frostbite's spot lobe, saturate(cosθ·scale + offset)² with scale = 1/(cos a − cos b) for the inner and
// outer half angles a < b and offset = −cos b·scale; cosθ between the aim and the direction from the light.
template<class S>
GONIO_FORCE_INLINE S spot_squared_linear(S cos_theta, S scale, S offset) {
    const S x = simd::min(simd::max(simd::mul_add(cos_theta, scale, offset), S(0)), S(1));
    return x * x;
}

} // namespace gonio::shading
