// Plain numbers and vectors of them in every lane of a kernel's scalar.
#pragma once

#include <gonio/shading/vec3.hpp>
#include <gonio/simd/scalar.hpp>

namespace gonio::detail {

// A number in every lane, rounded to what the lanes are.
template<class S>
GONIO_FORCE_INLINE S spread(double number) {
    return S(static_cast<simd::value_of<S>>(number));
}
template<class S, class Number>
GONIO_FORCE_INLINE shading::vec3<S> spread(const Number (&v)[3]) {
    return {spread<S>(v[0]), spread<S>(v[1]), spread<S>(v[2])};
}

} // namespace gonio::detail
