// Places on the surfaces of a stage, for tests.
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/transport/ray_bundle.hpp>
#include <gonio/transport/ray_caster.hpp>

#include <glm/geometric.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace gonio::test {

struct Place {
    Frame frame;
    std::size_t own;
};

// On the stage's surfaces, wherever rays from its camera end.
inline std::vector<Place> places_in(const Stage& stage) {
    using namespace detail;
    const RayCaster caster(stage);
    std::vector<Place> places;
    const glm::dvec3 forward = glm::normalize(stage.camera.target - stage.camera.position);
    for (const glm::dvec3& local : cosine_directions(40)) {
        const glm::dvec3 direction = frame_about(glm::dvec3(0.0), forward).to_world(local);
        const std::optional<Hit> hit = first_hit(stage, {stage.camera.position, direction});
        if (!hit) continue;
        const bool is_solid = !is_sheet(stage.surfaces[hit->surface].geometry);
        places.push_back(
            {frame_about(hit->position + 1e-4 * hit->normal, hit->normal), is_solid ? hit->surface : RayEnd::nothing});
    }
    return places;
}

} // namespace gonio::test
