#include <gonio/preview/shading_constants.hpp>
#include <gonio/scene/core_material.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace gonio {

namespace {

void copy(const glm::dvec3& from, float (&to)[3]) {
    for (int i = 0; i < 3; ++i)
        to[i] = static_cast<float>(from[i]);
}

void copy(const shading::vec3<double>& from, float (&to)[3]) {
    copy(glm::dvec3(from.x, from.y, from.z), to);
}

using shading::MaterialConstants;
using Kind = shading::MaterialConstants::Kind;

MaterialConstants constants_of(const shading::Lambert<double>& material) {
    MaterialConstants constants;
    constants.kind = Kind::lambert;
    copy(material.albedo, constants.albedo);
    return constants;
}

MaterialConstants constants_of(const shading::Frostbite<double>& material) {
    MaterialConstants constants;
    constants.kind = Kind::frostbite;
    copy(material.albedo, constants.albedo);
    copy(material.f0, constants.f0);
    constants.f90 = static_cast<float>(material.f90);
    constants.linear_roughness = static_cast<float>(material.linear_roughness);
    constants.alpha = static_cast<float>(material.alpha);
    return constants;
}

MaterialConstants constants_of(const shading::Ggx<double>& material) {
    MaterialConstants constants;
    constants.kind = Kind::ggx;
    copy(material.f0, constants.f0);
    constants.alpha = static_cast<float>(material.alpha);
    return constants;
}

MaterialConstants constants_of(const shading::KullaConty<double>& material) {
    MaterialConstants constants;
    constants.kind = Kind::kulla_conty;
    copy(material.f0, constants.f0);
    copy(material.multiple, constants.multiple);
    constants.alpha = static_cast<float>(material.loss.alpha);
    std::transform(std::begin(material.loss.c), std::end(material.loss.c), std::begin(constants.loss),
                   [](double c) { return static_cast<float>(c); });
    return constants;
}

MaterialConstants constants_of(const shading::Ue4<double>& material) {
    MaterialConstants constants;
    constants.kind = Kind::ue4;
    copy(material.albedo, constants.albedo);
    copy(material.f0, constants.f0);
    constants.cavity = static_cast<float>(material.cavity);
    constants.alpha = static_cast<float>(material.alpha);
    return constants;
}

MaterialConstants constants_of(const shading::Blinn<double>& material) {
    MaterialConstants constants;
    constants.kind = Kind::blinn;
    copy(material.albedo, constants.albedo);
    copy(material.f0, constants.f0);
    constants.power = static_cast<float>(material.power);
    return constants;
}

MaterialConstants constants_of(const shading::Eon<double>& material) {
    MaterialConstants constants;
    constants.kind = Kind::eon;
    copy(material.albedo, constants.albedo);
    constants.roughness = static_cast<float>(material.roughness);
    return constants;
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
    return std::visit([](const auto& kind) { return constants_of(core_material(kind)); }, material);
}

} // namespace gonio
