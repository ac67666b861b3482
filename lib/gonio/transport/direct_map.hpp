// Direct light on the patches of a stage, with shadows.
#pragma once

#include <gonio/scene/directional_albedo.hpp>
#include <gonio/transport/lit_scene.hpp>
#include <gonio/transport/patches.hpp>
#include <gonio/transport/thrown_light.hpp>

#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <vector>

namespace gonio::detail {

// By patch, the mean over points of it that are not covered, 2×2 or more near a light; per channel, in colours of
// luminance 1, so the illuminance is the luminance of the three.
struct DirectMap {
    std::vector<glm::dvec3> lx;
    std::vector<glm::dvec3> reflected_lx; // what leaves again
    // By light; none where lights are so many that nothing is thrown.
    std::vector<ThrowingLight> throwing;
};

// What reflects the light of a surface.
struct SurfaceAlbedo {
    DirectionalAlbedo by_cosine;
    glm::dvec3 over_hemisphere{0.0};
    std::optional<ThrowingLobe> lobe;
};

// Closed forms, whatever the method of the options is. `albedo` by surface: of light that arrives at a cosine, for
// which that towards the middle of a light is taken.
DirectMap direct_map(const Patches& patches, const LitScene& scene, std::span<const SurfaceAlbedo> albedo);

} // namespace gonio::detail
