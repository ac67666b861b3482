// The first surface that a ray meets, as the indirect light needs it: many rays, and blocked from both sides.
#pragma once

#include <gonio/scene/stage.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace gonio::detail {

// What a ray meets first. A one-sided surface that is met from behind blocks the ray and sends nothing back: it blocks
// direct light from both sides too.
struct RayEnd {
    static constexpr std::size_t nothing = static_cast<std::size_t>(-1);

    std::size_t surface = nothing; // `nothing` where the ray leaves the stage or meets a back
    int face = 0;
    double distance = 0.0; // infinite where the ray leaves the stage
    glm::dvec3 position{0.0};

    bool leaves() const { return distance == std::numeric_limits<double>::infinity(); }
};

class RayCaster {
public:
    explicit RayCaster(const Stage& stage) : stage_(stage) {}

    // `own` is a solid that the ray leaves, which no ray meets again; or RayEnd::nothing.
    RayEnd cast(const Ray& ray, std::size_t own) const;

private:
    const Stage& stage_;
};

} // namespace gonio::detail
