// A vector of plain numbers in every lane of a kernel's scalar.
#pragma once

#include <gonio/shading/vec3.hpp>

namespace gonio::detail {

// `Number`: float or double, as the lanes are.
template<class S, class Number>
GONIO_FORCE_INLINE shading::vec3<S> spread(const Number (&v)[3]) {
    return {S(v[0]), S(v[1]), S(v[2])};
}

} // namespace gonio::detail
