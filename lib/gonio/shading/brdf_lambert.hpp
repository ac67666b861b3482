// Lambert: the same radiance into every direction.
#pragma once

#include <gonio/shading/vec3.hpp>

namespace gonio::shading {

template<class S>
struct Lambert {
    vec3<S> albedo; // [0, 1]
};

} // namespace gonio::shading
