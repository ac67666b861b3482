// A lit stage as seen from one point, for reflections elsewhere.
#pragma once

#include <gonio/ibl/parallax.hpp>
#include <gonio/ibl/prefilter.hpp>

#include <glm/vec3.hpp>

#pragma GCC visibility push(default)
namespace gonio {

// A prefiltered picture of the stage from a place in it.
struct LocalProbe {
    glm::dvec3 position{0.0}; // [m]
    ParallaxBox box;          // about what is seen from there
    ParallaxSphere sphere;
    PrefilteredEnvironment light;
};

} // namespace gonio
#pragma GCC visibility pop
