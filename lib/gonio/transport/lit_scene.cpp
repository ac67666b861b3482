#include <gonio/base/parallel.hpp>
#include <gonio/scene/emitter.hpp>
#include <gonio/scene/occlusion.hpp>
#include <gonio/scene/probe_light.hpp>
#include <gonio/scene/reference.hpp>
#include <gonio/transport/lit_scene.hpp>
#include <gonio/transport/shading_constants.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <variant>

namespace gonio::detail {

namespace {

std::optional<shading::Approximation> approximation(IrradianceMethod method) {
    if (method == IrradianceMethod::frostbite) return shading::Approximation::frostbite;
    if (method == IrradianceMethod::ue4) return shading::Approximation::ue4;
    if (method == IrradianceMethod::point) return shading::Approximation::point;
    return std::nullopt;
}

// Whether the method treats a light with a size as a point.
bool becomes_point(const Shape& shape, IrradianceMethod method) {
    if (class_of(shape) != ShapeClass::area) return false;
    if (method == IrradianceMethod::point) return true;
    return method == IrradianceMethod::ue4 && is_flat(shape);
}

std::vector<LitLight> lit_lights(std::span<const Light> lights, IrradianceMethod method) {
    std::vector<LitLight> lit;
    lit.reserve(lights.size());
    LightTables tables;
    for (const Light& light : lights)
        lit.emplace_back(light, method, tables);
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
        if (lights[i].reach.body_radius > 0.0 && !lights[i].light.emitted_by)
            spheres.push_back(
                {lights[i].reach.center, lights[i].reach.body_radius * (1.0 + 1e-9), static_cast<std::uint32_t>(i)});
    return spheres;
}

// The material, or what its diffuse part scatters.
CoreMaterial seen_material(const Material& material, bool specular) {
    CoreMaterial whole = core_material(material);
    if (specular) return whole;
    return std::visit([](const auto& core) { return CoreMaterial(shading::diffuse_alone(core)); }, whole);
}

// The first surface with this material.
std::size_t first_with(const Stage& stage, const Material& material) {
    const auto found = std::find_if(stage.surfaces.begin(), stage.surfaces.end(),
                                    [&](const Surface& surface) { return are_same(surface.material, material); });
    return static_cast<std::size_t>(found - stage.surfaces.begin());
}

shading::MaterialConstants constants(const CoreMaterial& material) {
    return std::visit([](const auto& core) { return constants_of(core); }, material); // of shading, by argument
}

} // namespace

LitLight::LitLight(const Light& of_light, IrradianceMethod method, LightTables& tables)
    : light(of_light),
      is_dark(detail::is_dark(of_light)),
      constants(light_constants(of_light)),
      approximation(detail::approximation(method)),
      reach(reach_of(of_light, approximation.has_value(), tables.lit)),
      has_surface(class_of(of_light.shape) == ShapeClass::area) {
    const bool as_point = becomes_point(light.shape, method);
    is_punctual = as_point || !has_extent(light.shape);
    const bool is_uneven = !is_punctual && light.has_pattern() && method != IrradianceMethod::reference;
    if (is_punctual || (is_uneven && approximation))
        pattern.emplace(light, tables.webs, as_point);
    else if (is_uneven)
        luminance.emplace(light, tables.luminance, tables.webs);
    constants.specular_method = specular_method(method);
    if (is_punctual) approximation.reset();
    if (!as_point) return;
    constants.kind = shading::LightConstants::Kind::punctual;
    for (int channel = 0; channel < 3; ++channel)
        constants.color[channel] = static_cast<float>(light.color[channel]);
}

SurroundingsReflectance::SurroundingsReflectance(const Material& of_material, bool with_specular, bool is_fine)
    : material(of_material), specular(with_specular), fine(is_fine) {
    const CoreMaterial core = seen_material(material, specular);
    albedo = DirectionalAlbedo(core, fine ? DirectionalAlbedo::Fineness::fine : DirectionalAlbedo::Fineness::coarse);
    lobes = lobe_rays(core, fine ? 4 : 1);
    glm::dvec3 of_metal(0.0);
    for (const LobeRays& lobe : lobes)
        if (lobe.is_metal()) of_metal += lobe.albedo();
    const glm::dvec3 whole = albedo.over_hemisphere();
    for (int channel = 0; channel < 3; ++channel)
        if (of_metal[channel] > 0.0)
            by_metal[channel] = static_cast<float>(std::min(of_metal[channel] / whole[channel], 1.0));
}

bool SurroundingsReflectance::is_of(const Material& other, bool with_specular, bool is_fine) const {
    return specular == with_specular && fine == is_fine && are_same(material, other);
}

LitScene::LitScene(const Stage& on_stage, std::span<const Light> with_lights, const LightingOptions& with_options,
                   const SurroundingsReflectances& known)
    : stage(on_stage),
      shining(with_lights, !takes_points(with_options.method)),
      all_lights(shining.all()),
      options(with_options),
      kernels(shading::kernels(with_options.instruction_set)),
      intensity(transport::intensity_kernels(with_options.instruction_set)),
      luminance(transport::luminance_kernels(with_options.instruction_set)),
      lights(lit_lights(all_lights, with_options.method)),
      emitted(on_stage, all_lights),
      reaches(reach_spheres(lights)),
      bodies(body_spheres(lights)) {
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i)
        if (std::holds_alternative<Plane>(stage.surfaces[i].geometry)) planes.push_back(static_cast<std::uint32_t>(i));
    for (const Surface& surface : stage.surfaces) {
        core_materials.push_back(seen_material(surface.material, options.specular));
        materials.push_back(constants(core_materials.back()));
        diffuse_materials.push_back(constants(seen_material(surface.material, false)));
    }
    if (options.sky.is_dark() && options.bounces == 0) return;
    const bool has_sky = !options.sky.is_dark();
    const std::size_t count = core_materials.size();
    // Metals that light each other show small bright places in small bright places.
    std::vector<std::uint8_t> is_metal(count);
    std::size_t balls_and_boxes = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t first = first_with(stage, stage.surfaces[i].material);
        is_metal[i] = first < i ? is_metal[first] : has_metal_lobe(core_materials[i]) ? 1 : 0;
        const Primitive& geometry = stage.surfaces[i].geometry;
        if (is_metal[i] != 0 && (std::holds_alternative<Ball>(geometry) || std::holds_alternative<Box>(geometry)))
            ++balls_and_boxes;
    }
    const auto is_fine = [&](std::size_t i) { return has_sky || (balls_and_boxes > 1 && is_metal[i] != 0); };
    surroundings.resize(count);
    std::vector<std::size_t> to_make; // of surfaces with the same material the first
    for (std::size_t i = 0; i < count; ++i) {
        const Material& material = stage.surfaces[i].material;
        if (i < known.size() && known[i] != nullptr && known[i]->is_of(material, options.specular, is_fine(i)))
            surroundings[i] = known[i];
        else if (first_with(stage, material) == i)
            to_make.push_back(i);
    }
    parallel_for(to_make.size(), options.threads, [&](std::size_t i) {
        surroundings[to_make[i]] = std::make_shared<const SurroundingsReflectance>(
            stage.surfaces[to_make[i]].material, options.specular, is_fine(to_make[i]));
    });
    for (std::size_t i = 0; i < count; ++i)
        if (surroundings[i] == nullptr) surroundings[i] = surroundings[first_with(stage, stage.surfaces[i].material)];
}

void LitScene::find_shadowing(std::size_t surface, const SampleBounds& bounds, const LitLight& light,
                              std::vector<std::uint32_t>& found) const {
    constexpr double far = 1e6; // distance of the sphere that represents the sun [m]
    const LightReach& reach = light.reach;
    const Ball points{bounds.center, bounds.radius};
    const Ball body = reach.at_infinity ? Ball{bounds.center + far * reach.toward, far * reach.angular_radius_sin}
                                        : Ball{reach.center, reach.body_radius};
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i) {
        if (i == surface || light.light.is_emitted_by(i)) continue;
        const Primitive& primitive = stage.surfaces[i].geometry;
        // Visible points of a stage are in front of its planes: a plane can hide only a light that extends behind it.
        if (const auto* plane = std::get_if<Plane>(&primitive))
            if (glm::dot(plane->normal, body.center - plane->point) >=
                (light.has_surface ? reach_along(light.light, plane->normal) * (1.0 + 1e-9) : body.radius))
                continue;
        // A flat or a long light extends less towards a rectangle than its bounding sphere does.
        if (const auto* panel = std::get_if<Panel>(&primitive); panel != nullptr && light.has_surface) {
            const Ball towards{body.center, reach_along(light.light, panel->frame.z) * (1.0 + 1e-9)};
            if (!may_stand_between(Plane{panel->frame.origin, panel->frame.z}, points, towards)) continue;
        }
        if (light.has_surface && is_behind(primitive, light.light, points)) continue;
        if (may_stand_between(primitive, points, body)) found.push_back(static_cast<std::uint32_t>(i));
    }
}

bool LitScene::is_behind_plane(std::size_t surface, const SampleBounds& bounds, const LitLight& light) const {
    const LightReach& reach = light.reach;
    if (reach.at_infinity) return false;
    constexpr double room = 1e-6; // relative: points that touch a plane are on neither side of it
    const glm::dvec3 half = 0.5 * (bounds.high - bounds.low);
    return std::any_of(planes.begin(), planes.end(), [&](std::uint32_t i) {
        if (i == surface || light.light.is_emitted_by(i)) return false;
        const auto& plane = std::get<Plane>(stage.surfaces[i].geometry);
        const double of_light = glm::dot(plane.normal, reach.center - plane.point);
        if (!(of_light < 0.0)) return false;
        const double of_points = glm::dot(plane.normal, bounds.center - plane.point);
        const double margin = room * (glm::length(reach.center) + glm::length(bounds.center) +
                                      glm::length(plane.point) + bounds.radius + reach.body_radius);
        return of_light < -reach.body_radius - margin && of_points > glm::dot(glm::abs(plane.normal), half) + margin;
    });
}

double LitScene::visible_center(const LitLight& light, std::size_t surface, const glm::dvec3& position) const {
    if (!light.reach.at_infinity) {
        const std::optional<EmittingFace>& from = light.light.emitted_by;
        return visible_share(stage, surface, position, light.reach.center, 0.0, from ? from->surface : no_surface);
    }
    const auto& sun = std::get<SunShape>(light.light.shape);
    // A disk cannot have the outline of a hemisphere, so its half angle stays below 90°.
    const double half_angle = options.shadows == Shadows::hard ? 0.0 : std::min(0.5 * sun.diameter.value, 1.57);
    return visible_share_of_sun(stage, surface, position, light.reach.toward, half_angle);
}

} // namespace gonio::detail
