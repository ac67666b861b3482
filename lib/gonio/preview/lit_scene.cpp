#include <gonio/preview/detail/lit_scene.hpp>
#include <gonio/preview/shading_constants.hpp>
#include <gonio/scene/emitter.hpp>
#include <gonio/scene/reference.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <type_traits>

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

std::vector<Occluder> occluders_of(const Stage& stage) {
    std::vector<Occluder> occluders;
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i)
        std::visit(
            [&](const auto& geometry) {
                using Geometry = std::decay_t<decltype(geometry)>;
                if constexpr (std::is_same_v<Geometry, Ball>)
                    occluders.push_back({i, geometry.center, geometry.radius});
                else if constexpr (!std::is_same_v<Geometry, Plane>)
                    occluders.push_back({i, glm::dvec3(0.0), std::numeric_limits<double>::infinity()});
            },
            stage.surfaces[i].geometry);
    return occluders;
}

} // namespace

LitScene::LitScene(const Stage& on_stage, std::span<const Light> with_lights, const RenderOptions& with_options)
    : stage(on_stage),
      all_lights(with_lights),
      options(with_options),
      kernels(shading::kernels(with_options.instruction_set)),
      intensity(preview::intensity_kernels(with_options.instruction_set)),
      lights(lit_lights(with_lights)),
      occluders(occluders_of(on_stage)),
      reaches(reach_spheres(lights)),
      bodies(body_spheres(lights)) {
    for (const Surface& surface : stage.surfaces)
        materials.push_back(material_constants(surface.material));
}

bool LitScene::may_be_shadowed(std::size_t surface, const SampleBounds& bounds, const LitLight& light) const {
    // All ways from the points to the light lie within the hull of two spheres, which the wider one swept holds.
    const glm::dvec3 way = light.reach.at_infinity ? light.reach.toward * 1e6 : light.reach.center - bounds.center;
    const double length2 = glm::dot(way, way);
    const double room = std::max(bounds.radius, std::max(light.shadow_radius, light.reach.body_radius));
    return std::any_of(occluders.begin(), occluders.end(), [&](const Occluder& occluder) {
        if (occluder.surface == surface) return false;
        const glm::dvec3 to_occluder = occluder.center - bounds.center;
        const double along = length2 > 0.0 ? std::clamp(glm::dot(to_occluder, way) / length2, 0.0, 1.0) : 0.0;
        const double near = (occluder.radius + room) * (1.0 + 1e-6);
        const glm::dvec3 apart = to_occluder - along * way;
        return glm::dot(apart, apart) <= near * near;
    });
}

} // namespace gonio::detail
