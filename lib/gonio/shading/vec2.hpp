// vec2<S>: two components in a plane, of a scalar S as for vec3.
#pragma once

#include <gonio/simd/math.hpp>
#include <gonio/simd/twin.hpp>

namespace gonio::shading {

template<class S>
struct vec2 {
    S x, y;

    GONIO_FORCE_INLINE friend vec2 operator+(vec2 a, vec2 b) { return {a.x + b.x, a.y + b.y}; }
    GONIO_FORCE_INLINE friend vec2 operator-(vec2 a, vec2 b) { return {a.x - b.x, a.y - b.y}; }
    GONIO_FORCE_INLINE friend vec2 operator*(vec2 a, S s) { return {a.x * s, a.y * s}; }
};
template<class S>
GONIO_FORCE_INLINE S dot(vec2<S> a, vec2<S> b) {
    return simd::mul_add(a.x, b.x, a.y * b.y);
}
// Positive if b is counter-clockwise of a.
template<class S>
GONIO_FORCE_INLINE S cross(vec2<S> a, vec2<S> b) {
    return a.x * b.y - a.y * b.x;
}
template<class S>
GONIO_FORCE_INLINE vec2<S> select(simd::mask_of<S> condition, vec2<S> if_true, vec2<S> if_false) {
    return {simd::select(condition, if_true.x, if_false.x), simd::select(condition, if_true.y, if_false.y)};
}
template<class S>
GONIO_FORCE_INLINE vec2<S> normalized(vec2<S> a) {
    return a * (S(1) / simd::sqrt(simd::max(dot(a, a), S(1e-36))));
}

} // namespace gonio::shading
