// Converts vectors of scenes to those of the shading core, and back; and to the plain numbers that kernels read.
#pragma once

#include <gonio/shading/vec3.hpp>

#include <glm/vec3.hpp>

namespace gonio::detail {

inline shading::vec3<double> vec(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}
inline glm::dvec3 vec(shading::vec3<double> v) {
    return {v.x, v.y, v.z};
}

template<class Number>
void put(Number (&to)[3], const glm::dvec3& v) {
    for (int axis = 0; axis < 3; ++axis)
        to[axis] = static_cast<Number>(v[axis]);
}

} // namespace gonio::detail
