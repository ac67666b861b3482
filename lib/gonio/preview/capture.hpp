// A lit stage as it looks from one point in all directions.
#pragma once

#include <gonio/preview/render.hpp>
#include <gonio/sky/environment_map.hpp>
#include <gonio/transport/local_probe.hpp>

#include <glm/vec3.hpp>

#include <span>

#pragma GCC visibility push(default)
namespace gonio {

// A cube-strip of six pictures with `side`² pixels, in cd/m², with the sky where nothing else is seen. Uses these
// options: those of the light, `known` and `shows_lights`; lights that are not shown still light the stage. Fails
// (usage) if the point is inside a solid, on or behind a plane, and as render() and environment_grid().
Result<EnvironmentMap> capture(const Stage& stage, std::span<const Light> lights, const glm::dvec3& position, int side,
                               const RenderOptions& options);

// For SurroundingsMethod::parallax_box and parallax_sphere: such a picture without the lights themselves, whose
// highlights are direct light. The sphere is centred at the point and as wide as the mean distance to what is seen, the
// box reaches to what is seen along the axes; both at most `farthest_m`. Fails as capture().
Result<LocalProbe> local_probe(const Stage& stage, std::span<const Light> lights, const glm::dvec3& position,
                               const RenderOptions& options);

// How far the surroundings of a local probe reach at most.
inline constexpr double farthest_m = 20.0;

} // namespace gonio
#pragma GCC visibility pop
