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
    struct Known {
        bool operator()(const PointShape&) const { return true; }
        bool operator()(const SpotShape&) const { return true; }
        bool operator()(const FrustumShape&) const { return true; }
        bool operator()(const ProfileShape&) const { return true; }
        bool operator()(const SphereShape&) const { return true; }
        bool operator()(const DiskShape&) const { return false; }
        bool operator()(const RectShape&) const { return false; }
        bool operator()(const TubeShape&) const { return false; }
        bool operator()(const SunShape&) const { return false; }
    };
    return std::visit(Known{}, shape);
}

shading::LightConstants light_constants(const Light& light) {
    shading::LightConstants constants;
    copy(light.frame.origin, constants.position);
    if (light.range) constants.inverse_range = static_cast<float>(1.0 / light.range->value);
    if (const auto* sphere = std::get_if<SphereShape>(&light.shape)) {
        constants.kind = shading::LightConstants::Kind::sphere;
        constants.radius = static_cast<float>(sphere->radius.value);
        copy(light.color * light.luminance.value, constants.color);
    } else {
        copy(light.color, constants.color);
    }
    return constants;
}

shading::MaterialConstants material_constants(const Material& material) {
    return std::visit([](const auto& kind) { return constants_of(kind); }, material);
}

} // namespace gonio
