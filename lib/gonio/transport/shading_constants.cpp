#include <gonio/light/shape_traits.hpp>
#include <gonio/scene/core_material.hpp>
#include <gonio/transport/shading_constants.hpp>

#include <variant>

namespace gonio {

namespace {

void copy(const glm::dvec3& from, float (&to)[3]) {
    for (int i = 0; i < 3; ++i)
        to[i] = static_cast<float>(from[i]);
}

// What each light of the core contributes to the constants, besides its centre and colour.
using shading::LightConstants;

void take(const shading::SphereLight<double>& light, LightConstants& constants) {
    constants.kind = LightConstants::Kind::sphere;
    constants.radius = static_cast<float>(light.radius);
}
void take(const shading::DiskLight<double>& light, LightConstants& constants) {
    constants.kind = LightConstants::Kind::disk;
    constants.radius = static_cast<float>(light.radius);
    constants.two_sided = light.two_sided;
}
void take(const shading::EllipseLight<double>& light, LightConstants& constants) {
    constants.kind = LightConstants::Kind::ellipse;
    constants.width = static_cast<float>(2.0 * light.half_width);
    constants.height = static_cast<float>(2.0 * light.half_height);
    constants.two_sided = light.two_sided;
}
void take(const shading::RectangleLight<double>& light, LightConstants& constants) {
    constants.kind = LightConstants::Kind::rectangle;
    constants.width = static_cast<float>(light.width);
    constants.height = static_cast<float>(light.height);
    constants.two_sided = light.two_sided;
}
void take(const shading::SunLight<double>& /*its angle below*/, LightConstants& constants) {
    constants.kind = LightConstants::Kind::sun;
    constants.inverse_range = 0.0F;
}
void take(const shading::TubeLight<double>& light, LightConstants& constants) {
    constants.kind = LightConstants::Kind::tube;
    copy(glm::dvec3(light.axis.x, light.axis.y, light.axis.z), constants.axis);
    constants.radius = static_cast<float>(light.radius);
    constants.length = static_cast<float>(light.length);
}
void take(const shading::CylinderLight<double>& light, LightConstants& constants) {
    constants.kind = LightConstants::Kind::cylinder;
    copy(glm::dvec3(light.axis.x, light.axis.y, light.axis.z), constants.axis);
    constants.radius = static_cast<float>(light.radius);
    constants.length = static_cast<float>(light.length);
}

} // namespace

shading::LightConstants light_constants(const Light& light) {
    shading::LightConstants constants;
    copy(light.frame.origin, constants.position);
    if (light.range) constants.inverse_range = static_cast<float>(1.0 / light.range->value);
    copy(-light.frame.z, constants.axis);
    copy(light.frame.x, constants.width_direction);
    with_traits(light.shape, [&]<class Kind>(const Kind& kind, ShapeTraits<Kind>) {
        if constexpr (!PunctualShape<Kind>) take(ShapeTraits<Kind>::core(kind, light.frame, light.color), constants);
    });
    if (const auto* sun = std::get_if<SunShape>(&light.shape)) // the core light has only its sine
        constants.angular_radius = static_cast<float>(0.5 * sun->diameter.value);
    const bool punctual = constants.kind == LightConstants::Kind::punctual;
    copy(punctual ? light.color : light.color * light.luminance.value, constants.color);
    return constants;
}

shading::MaterialConstants material_constants(const Material& material) {
    return std::visit([](const auto& core) { return constants_of(core); }, core_material(material));
}

} // namespace gonio
