// A stage and its lights as the tiles of a picture need them: made once, then read by all threads.
#pragma once

#include <gonio/light/light_parts.hpp>
#include <gonio/scene/core_material.hpp>
#include <gonio/scene/directional_albedo.hpp>
#include <gonio/scene/emissive_lights.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/transport/intensity_pattern.hpp>
#include <gonio/transport/light_reach.hpp>
#include <gonio/transport/light_tree.hpp>
#include <gonio/transport/lighting_options.hpp>
#include <gonio/transport/lobe_rays.hpp>
#include <gonio/transport/luminance_pattern.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gonio::detail {

class NamedSurroundings;
class SkyLight;

// What lights with the same profile share.
struct LightTables {
    WebTables webs;
    LuminanceTables luminance;
    WebsLitCosines lit;
};

struct LitLight {
    // The light must outlive this.
    LitLight(const Light& of_light, IrradianceMethod method, LightTables& tables);

    const Light& light;
    bool is_dark = false;
    shading::LightConstants constants;                   // the position is set for each group of points
    std::optional<IntensityPattern> pattern;             // of a punctual light, or of a masked one that is taken so
    std::optional<LuminancePattern> luminance;           // of an area light that is not uniform, by all other methods
    bool is_punctual = false;                            // or treated as a point
    std::optional<shading::Approximation> approximation; // of the irradiance, for the methods that use one
    LightReach reach;
    // Whether soft shadows use the light's surface (soft_shadow.hpp): true if it has one at a finite distance.
    bool has_surface = false;
};

// What a material reflects of light from all around. It depends on the material alone, and takes longer to make than a
// small picture: pictures of the same materials share it.
struct SurroundingsReflectance {
    SurroundingsReflectance(const Material& of_material, bool with_specular, bool is_fine);

    // Whether it is that of such a surface.
    bool is_of(const Material& other, bool with_specular, bool is_fine) const;

    Material material;
    bool specular = true;
    bool fine = false; // for skies, which vary more than a stage, and for metals among each other
    DirectionalAlbedo albedo;
    std::vector<LobeRays> lobes; // the glossy ones
    glm::vec3 by_metal{0.0F};    // the share that lobes of metals have in the albedo, per channel
};
using SurroundingsReflectances = std::vector<std::shared_ptr<const SurroundingsReflectance>>; // by surface

struct LitScene {
    // `known`: of another picture; taken for the surfaces that it fits.
    LitScene(const Stage& on_stage, std::span<const Light> with_lights, const LightingOptions& with_options,
             const SurroundingsReflectances& known = {});

    // Finds the surfaces that may be between the light and the points of `surface` within the bounds; not the one that
    // emits it.
    void find_shadowing(std::size_t surface, const SampleBounds& bounds, const LitLight& light,
                        std::vector<std::uint32_t>& found) const;

    // Whether a plane of the stage hides all of the light from every point of `surface` within the bounds, by bounds:
    // such points get exactly 0. False for lights at infinity.
    bool is_behind_plane(std::size_t surface, const SampleBounds& bounds, const LitLight& light) const;

    // Whether shadows of this light are soft: those of other lights are visible_center().
    bool has_soft_shadow(const LitLight& light) const { return light.has_surface && options.shadows == Shadows::soft; }
    // The share of a light without such shadows that reaches a point of `surface`; the sun's, of its disk.
    double visible_center(const LitLight& light, std::size_t surface, const glm::dvec3& position) const;

    const Stage& stage;
    ShiningLights shining;             // of the lights that are given: the faces of luminaires in their place
    std::span<const Light> all_lights; // these
    const LightingOptions& options;
    const shading::Kernels& kernels;
    const transport::IntensityKernels& intensity;
    const transport::LuminanceKernels& luminance;
    std::vector<LitLight> lights;                              // one for each of all_lights
    std::vector<shading::MaterialConstants> materials;         // one for each surface
    std::vector<shading::MaterialConstants> diffuse_materials; // the same without specular lobes
    std::vector<std::uint32_t> planes;                         // the surfaces that are planes
    std::vector<CoreMaterial> core_materials;                  // the same as `materials`, in double
    SurroundingsReflectances surroundings;                     // empty without a sky and without bounces
    EmittedLights emitted;                                     // what surfaces show as their own
    LightTree reaches;                                         // spheres by range, of the lights that are not dark
    LightTree bodies; // bounding spheres, of the lights with a surface that is not the stage's
    // To be set by who has them.
    const SkyLight* sky = nullptr;            // null without a sky
    const NamedSurroundings* named = nullptr; // null for SurroundingsMethod::exact
};

} // namespace gonio::detail
