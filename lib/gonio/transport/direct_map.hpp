// Direct light on the patches of a stage, with shadows.
#pragma once

#include <gonio/scene/directional_albedo.hpp>
#include <gonio/transport/lit_scene.hpp>
#include <gonio/transport/patches.hpp>

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace gonio::detail {

// By patch, the mean over points of it that are not covered, 2×2 or more near a light; per channel, in colours of
// luminance 1, so the illuminance is the luminance of the three.
struct DirectMap {
    std::vector<glm::dvec3> lx;
    std::vector<glm::dvec3> reflected_lx; // what leaves again
};

// Closed forms, whatever the method of the options is. `albedo` by surface: of light that arrives at a cosine, for
// which that towards the middle of a light is taken.
DirectMap direct_map(const Patches& patches, const LitScene& scene, std::span<const DirectionalAlbedo> albedo,
                     std::span<const glm::dvec3> hemispherical_albedo);

} // namespace gonio::detail
