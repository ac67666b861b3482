// Direct light on the patches of a stage: the illuminance of all lights, per channel, with shadows.
#pragma once

#include <gonio/transport/lit_scene.hpp>
#include <gonio/transport/patches.hpp>

#include <glm/vec3.hpp>

#include <vector>

namespace gonio::detail {

// For each patch, the mean over points of it that are not covered, 2×2 or more near a light [lx]: colours of luminance
// 1, so the illuminance is the luminance of the three. Closed forms, whatever the method of the options is.
std::vector<glm::dvec3> direct_map(const Patches& patches, const LitScene& scene);

} // namespace gonio::detail
