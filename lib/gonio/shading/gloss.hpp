// The glossy lobe of a material, in the form that area lights evaluate. A lobe other than GGX is defined beside its
// material.
#pragma once

#include <gonio/shading/ggx.hpp>
#include <gonio/shading/vec2.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

#include <numbers>

namespace gonio::shading {

// The sum s = l + v of two directions in the surface's own frame, along their half vector.
template<class S>
struct HalfVector {
    vec3<S> sum;
    S along2;  // (n·s)²
    S across2; // ‖n×s‖², which does not cancel
    S square;  // |s|²
    S l_dot_h; // |s|/2
};

// l and v are of unit length, in a frame with the normal as z. Any value where both are in the surface and opposite.
template<class S>
GONIO_FORCE_INLINE HalfVector<S> half_vector(vec3<S> l, vec3<S> v) {
    const vec3<S> s = l + v;
    const S along2 = s.z * s.z;
    const S across2 = simd::mul_add(s.x, s.x, s.y * s.y);
    const S square = simd::max(along2 + across2, S(1e-36));
    return {s, along2, across2, square, S(0.5) * simd::sqrt(square)};
}

// Slopes of half vectors over the width of a lobe that is the same in all directions.
template<class S>
struct EvenSlopes {
    S inverse_width;

    GONIO_FORCE_INLINE vec2<S> operator()(vec2<S> slope) const { return slope * inverse_width; }
};

// GGX of α ≥ minimum_alpha.
template<class S>
struct GgxLobe {
    static constexpr bool is_even = true; // the same in all directions of the surface

    S alpha;

    // The lobe [1/sr] for F = 1 in the surface's own frame; n·l, n·v > 0.
    GONIO_FORCE_INLINE S value(vec3<S> l, vec3<S> v, const HalfVector<S>& h) const {
        const S of_v = l.z * widened_cosine_ggx(v.z, alpha);
        const S of_l = v.z * widened_cosine_ggx(l.z, alpha);
        // D V with one division. Its denominator may vanish only where l and v are opposite in the surface.
        const S t = simd::mul_add(alpha * alpha, h.along2, h.across2);
        return alpha * alpha * S(0.5 * std::numbers::inv_pi) * (h.square * h.square) /
               simd::max(t * t * (of_v + of_l), S(1e-36));
    }
    // The ratio of this lobe's directional albedo to that of the GGX lobe with the same α.
    GONIO_FORCE_INLINE S albedo_share(S /*n_dot_v*/) const { return S(1); }

    GONIO_FORCE_INLINE EvenSlopes<S> slopes() const { return {S(1) / simd::max(alpha, S(minimum_alpha))}; }
    GONIO_FORCE_INLINE S width(vec2<S> /*direction*/) const { return alpha; }

    // `widened` is α or more: ggx.hpp.
    GONIO_FORCE_INLINE SpecularTerms<S> operator()(vec3<S> n, vec3<S> l, vec3<S> v, S widened) const {
        return specular_ggx(n, l, v, alpha, widened);
    }
};

// A lobe times its reflectance f0 + (f90 − f0)·grazing and times `factor`.
template<class S, class Lobe>
struct Gloss {
    Lobe lobe;
    vec3<S> f0;
    S f90, factor;

    GONIO_FORCE_INLINE vec3<S> operator()(SpecularTerms<S> terms) const {
        return reflected_part(f0, f90, terms) * factor;
    }
};

} // namespace gonio::shading
