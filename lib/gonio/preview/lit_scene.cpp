#include <gonio/preview/detail/lit_scene.hpp>
#include <gonio/preview/shading_constants.hpp>
#include <gonio/scene/emitter.hpp>
#include <gonio/scene/occlusion.hpp>
#include <gonio/scene/reference.hpp>

#include <algorithm>

namespace gonio::detail {

namespace {

std::vector<LitLight> lit_lights(std::span<const Light> lights) {
    std::vector<LitLight> lit;
    lit.reserve(lights.size());
    WebTables tables;
    for (const Light& light : lights) {
        const bool punctual = !has_extent(light.shape);
        lit.push_back({light, is_dark(light), light_constants(light), IntensityPattern(light, tables),
                       punctual || mask_of(light.shape).web != nullptr, punctual, reach_of(light, true),
                       shadow_radius(light)});
    }
    return lit;
}

std::vector<LightSphere> reach_spheres(std::span<const LitLight> lights) {
    std::vector<LightSphere> spheres;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (!lights[i].is_dark)
            spheres.push_back(
                {lights[i].reach.center, lights[i].reach.range * (1.0 + 1e-4), static_cast<std::uint32_t>(i)});
    return spheres;
}

std::vector<LightSphere> body_spheres(std::span<const LitLight> lights) {
    std::vector<LightSphere> spheres;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (lights[i].reach.body_radius > 0.0)
            spheres.push_back(
                {lights[i].reach.center, lights[i].reach.body_radius * (1.0 + 1e-9), static_cast<std::uint32_t>(i)});
    return spheres;
}

} // namespace

LitScene::LitScene(const Stage& on_stage, std::span<const Light> with_lights, const RenderOptions& with_options)
    : stage(on_stage),
      all_lights(with_lights),
      options(with_options),
      kernels(shading::kernels(with_options.instruction_set)),
      intensity(preview::intensity_kernels(with_options.instruction_set)),
      lights(lit_lights(with_lights)),
      reaches(reach_spheres(lights)),
      bodies(body_spheres(lights)) {
    for (const Surface& surface : stage.surfaces)
        materials.push_back(material_constants(surface.material));
}

bool LitScene::may_be_shadowed(std::size_t surface, const SampleBounds& bounds, const LitLight& light) const {
    constexpr double far = 1e6; // where the sun is put, in its size [m]
    const LightReach& reach = light.reach;
    const Ball points{bounds.center, bounds.radius};
    const Ball body = reach.at_infinity ? Ball{bounds.center + far * reach.toward, far * reach.angular_radius_sin}
                                        : Ball{reach.center, std::max(light.shadow_radius, reach.body_radius)};
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i)
        if (i != surface && may_stand_between(stage.surfaces[i].geometry, points, body)) return true;
    return false;
}

} // namespace gonio::detail
