#include <gonio/preview/shading_constants.hpp>
#include <gonio/scene/core_material.hpp>

#include <variant>

namespace gonio {

namespace {

void copy(const glm::dvec3& from, float (&to)[3]) {
    for (int i = 0; i < 3; ++i)
        to[i] = static_cast<float>(from[i]);
}

} // namespace

shading::LightConstants light_constants(const Light& light) {
    using LightKind = shading::LightConstants::Kind;
    shading::LightConstants constants;
    copy(light.frame.origin, constants.position);
    if (light.range) constants.inverse_range = static_cast<float>(1.0 / light.range->value);
    copy(-light.frame.z, constants.axis);
    copy(light.frame.x, constants.width_direction);
    if (const auto* sphere = std::get_if<SphereShape>(&light.shape)) {
        constants.kind = LightKind::sphere;
        constants.radius = static_cast<float>(sphere->radius.value);
    } else if (const auto* disk = std::get_if<DiskShape>(&light.shape)) {
        constants.kind = LightKind::disk;
        constants.radius = static_cast<float>(disk->radius.value);
        constants.two_sided = disk->two_sided;
    } else if (const auto* rect = std::get_if<RectShape>(&light.shape)) {
        constants.kind = LightKind::rectangle;
        constants.width = static_cast<float>(rect->width.value);
        constants.height = static_cast<float>(rect->height.value);
        constants.two_sided = rect->two_sided;
    } else if (const auto* tube = std::get_if<TubeShape>(&light.shape)) {
        constants.kind = LightKind::tube;
        copy(light.frame.x, constants.axis);
        constants.radius = static_cast<float>(tube->radius.value);
        constants.length = static_cast<float>(tube->length.value);
    }
    if (const auto* sun = std::get_if<SunShape>(&light.shape)) {
        constants.kind = LightKind::sun;
        constants.angular_radius = static_cast<float>(0.5 * sun->diameter.value);
        constants.inverse_range = 0.0F;
    }
    const bool punctual = constants.kind == LightKind::punctual;
    copy(punctual ? light.color : light.color * light.luminance.value, constants.color);
    return constants;
}

shading::MaterialConstants material_constants(const Material& material) {
    return std::visit([](const auto& core) { return shading::constants_of(core); }, core_material(material));
}

} // namespace gonio
