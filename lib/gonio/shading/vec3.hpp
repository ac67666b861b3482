// vec3<S>: three numbers of a scalar S: float, double or a pack. The public interface uses GLM, which does not accept
// packs.
#pragma once

#include <gonio/simd/doubles.hpp>
#include <gonio/simd/twin.hpp>

namespace gonio::shading {

template<class S>
struct vec3 {
    S x, y, z;

    GONIO_FORCE_INLINE friend vec3 operator+(vec3 a, vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    GONIO_FORCE_INLINE friend vec3 operator-(vec3 a, vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    GONIO_FORCE_INLINE friend vec3 operator*(vec3 a, vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
    GONIO_FORCE_INLINE friend vec3 operator*(vec3 a, S s) { return {a.x * s, a.y * s, a.z * s}; }
};

template<class S>
GONIO_FORCE_INLINE S dot(vec3<S> a, vec3<S> b) {
    return simd::mul_add(a.x, b.x, simd::mul_add(a.y, b.y, a.z * b.z));
}

template<class S>
GONIO_FORCE_INLINE vec3<S> cross(vec3<S> a, vec3<S> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// The same, with two roundings per component where there is FMA; a × a is then 0 only within rounding.
template<class S>
GONIO_FORCE_INLINE vec3<S> fused_cross(vec3<S> a, vec3<S> b) {
    return {simd::mul_add(a.y, b.z, -(a.z * b.y)), simd::mul_add(a.z, b.x, -(a.x * b.z)),
            simd::mul_add(a.x, b.y, -(a.y * b.x))};
}

// a·s + b, rounded once per component where there is FMA.
template<class S>
GONIO_FORCE_INLINE vec3<S> mul_add(vec3<S> a, S s, vec3<S> b) {
    return {simd::mul_add(a.x, s, b.x), simd::mul_add(a.y, s, b.y), simd::mul_add(a.z, s, b.z)};
}

template<class S>
GONIO_FORCE_INLINE S length(vec3<S> a) {
    return simd::sqrt(dot(a, a));
}

// The largest magnitude of a component.
template<class S>
GONIO_FORCE_INLINE S largest_component(vec3<S> a) {
    return simd::max(simd::abs(a.x), simd::max(simd::abs(a.y), simd::abs(a.z)));
}

template<class S>
GONIO_FORCE_INLINE vec3<S> select(simd::mask_of<S> condition, vec3<S> if_true, vec3<S> if_false) {
    return {simd::select(condition, if_true.x, if_false.x), simd::select(condition, if_true.y, if_false.y),
            simd::select(condition, if_true.z, if_false.z)};
}

template<class S>
GONIO_FORCE_INLINE vec3<simd::wider<S>> widen(vec3<S> a) {
    return {simd::widen(a.x), simd::widen(a.y), simd::widen(a.z)};
}

// 1/x, and 0 where x is 0.
template<class S>
GONIO_FORCE_INLINE S reciprocal_or_zero(S x) {
    const auto zero = x == S(0);
    return simd::select(zero, S(0), S(1) / simd::select(zero, S(1), x));
}

// The zero vector where the length is 0; no overflow for |a| up to about 1e19 (float).
template<class S>
GONIO_FORCE_INLINE vec3<S> normalized(vec3<S> a) {
    return a * reciprocal_or_zero(length(a));
}

} // namespace gonio::shading
