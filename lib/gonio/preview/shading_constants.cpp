#include <gonio/preview/shading_constants.hpp>
#include <gonio/shading/brdf_frostbite.hpp>

#include <cmath>

namespace gonio {

namespace {

void copy(const glm::dvec3& from, float (&to)[3]) {
    for (int i = 0; i < 3; ++i)
        to[i] = static_cast<float>(from[i]);
}

void copy(const shading::vec3<double>& from, float (&to)[3]) {
    copy(glm::dvec3(from.x, from.y, from.z), to);
}

shading::MaterialConstants constants_of(const LambertMaterial& material) {
    shading::MaterialConstants constants;
    constants.kind = shading::MaterialConstants::Kind::lambert;
    copy(material.albedo, constants.albedo);
    return constants;
}

shading::MaterialConstants constants_of(const FrostbiteMaterial& material) {
    const shading::vec3<double> base{material.base.x, material.base.y, material.base.z};
    const auto made = shading::frostbite_material(base, material.smoothness, material.metal, material.reflectance);
    shading::MaterialConstants constants;
    constants.kind = shading::MaterialConstants::Kind::frostbite;
    copy(made.albedo, constants.albedo);
    copy(made.f0, constants.f0);
    constants.f90 = static_cast<float>(made.f90);
    constants.linear_roughness = static_cast<float>(made.linear_roughness);
    constants.alpha = static_cast<float>(made.alpha);
    return constants;
}

} // namespace

bool has_kernel(const Shape& shape) {
    return !std::holds_alternative<SunShape>(shape);
}

shading::LightConstants light_constants(const Light& light) {
    using Kind = shading::LightConstants::Kind;
    shading::LightConstants constants;
    copy(light.frame.origin, constants.position);
    if (light.range) constants.inverse_range = static_cast<float>(1.0 / light.range->value);
    copy(-light.frame.z, constants.axis);
    copy(light.frame.x, constants.width_direction);
    if (const auto* sphere = std::get_if<SphereShape>(&light.shape)) {
        constants.kind = Kind::sphere;
        constants.radius = static_cast<float>(sphere->radius.value);
    } else if (const auto* disk = std::get_if<DiskShape>(&light.shape)) {
        constants.kind = Kind::disk;
        constants.radius = static_cast<float>(disk->radius.value);
        constants.two_sided = disk->two_sided;
    } else if (const auto* rect = std::get_if<RectShape>(&light.shape)) {
        constants.kind = Kind::rectangle;
        constants.width = static_cast<float>(rect->width.value);
        constants.height = static_cast<float>(rect->height.value);
        constants.two_sided = rect->two_sided;
    } else if (const auto* tube = std::get_if<TubeShape>(&light.shape)) {
        constants.kind = Kind::tube;
        copy(light.frame.x, constants.axis);
        constants.radius = static_cast<float>(tube->radius.value);
        constants.length = static_cast<float>(tube->length.value);
    }
    const bool punctual = constants.kind == Kind::punctual;
    copy(punctual ? light.color : light.color * light.luminance.value, constants.color);
    return constants;
}

shading::MaterialConstants material_constants(const Material& material) {
    return std::visit([](const auto& kind) { return constants_of(kind); }, material);
}

} // namespace gonio
