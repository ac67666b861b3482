// Products of vectors whose sums are rounded term by term on every instruction set, so that floats have the same bits
// on all of them, as doubles have anyway (simd/doubles.hpp).
#pragma once

#include <gonio/shading/vec3.hpp>
#include <gonio/simd/scalar.hpp>

namespace gonio::detail::unfused {

template<class S>
GONIO_FORCE_INLINE S dot(const shading::vec3<S>& a, const shading::vec3<S>& b) {
    return a.x * b.x + (a.y * b.y + a.z * b.z);
}
template<class S>
GONIO_FORCE_INLINE shading::vec3<S> cross(const shading::vec3<S>& a, const shading::vec3<S>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template<class S>
GONIO_FORCE_INLINE S length(const shading::vec3<S>& v) {
    return simd::sqrt(unfused::dot(v, v));
}

} // namespace gonio::detail::unfused
