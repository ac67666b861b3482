#include <gonio/light/shape_traits.hpp>
#include <gonio/scene/core_vector.hpp>
#include <gonio/scene/emitter.hpp>
#include <gonio/scene/light_sampler.hpp>
#include <gonio/shading/falloff.hpp>
#include <gonio/shading/seen_from.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gonio::detail {

namespace {

using Vec = shading::vec3<double>;

// Whether the receiver is in front of an emitting side, or in its plane: there the sampler decides what is visible.
template<class CoreLight>
bool shines_on(const CoreLight& light, Vec to_center) {
    if constexpr (requires { light.two_sided; }) return light.two_sided || !(dot(to_center, light.axis) > 0.0);
    return true;
}

shading::SphereSampler<double> sampler_of(const shading::SphereLight<double>& light, Vec to_center) {
    return {to_center, light.radius};
}
shading::SphereSampler<double> sampler_of(const shading::SunLight<double>& light, Vec /*to_center*/) {
    return {light.toward, light.sine};
}
shading::DiskSampler<double> sampler_of(const shading::DiskLight<double>& light, Vec to_center) {
    return {to_center, light.axis, light.radius};
}
shading::RectangleSampler<double> sampler_of(const shading::RectangleLight<double>& light, Vec to_center) {
    return {to_center, light.axis, light.width_direction, light.width, light.height};
}
shading::TubeSampler<double> sampler_of(const shading::TubeLight<double>& light, Vec to_center) {
    return {to_center, light.axis, light.radius, light.length};
}
shading::CylinderSampler<double> sampler_of(const shading::CylinderLight<double>& light, Vec to_center) {
    return {to_center, light.axis, light.radius, light.length};
}

} // namespace

LightSampler::Seen LightSampler::seen_from(const Light& light, const glm::dvec3& to_center) {
    const Seen none{shading::SphereSampler<double>(vec(to_center), 0.0), false};
    return with_core_light(light.shape, light.frame, light.color, none, [&](const auto& core) -> Seen {
        const auto seen = shading::exactly_seen_from(core, vec(to_center));
        return {sampler_of(seen.light, seen.to_center), shines_on(core, vec(to_center))};
    });
}

LightSampler::LightSampler(const Light& light, const glm::dvec3& receiver)
    : light_(light), receiver_(receiver), seen_(seen_from(light, light.frame.origin - receiver)) {
    if (!seen_.shines) return;
    const glm::dvec3 to_center = light.frame.origin - receiver;
    const bool windowed = light.range && class_of(light.shape) != ShapeClass::sun;
    luminance_nt_ = light.luminance.value *
                    (windowed ? shading::window_squared(glm::length(to_center), 1.0 / light.range->value) : 1.0);
}

shading::LightSample<double> LightSampler::sample(double u0, double u1) const {
    if (!(luminance_nt_ > 0.0)) return {{0.0, 0.0, 1.0}, 0.0};
    return std::visit([&](const auto& sampler) { return sampler.sample(u0, u1); }, seen_.sampler);
}

double LightSampler::pdf(Vec direction) const {
    if (!(luminance_nt_ > 0.0)) return 0.0;
    return std::visit([&](const auto& sampler) { return sampler.pdf(direction); }, seen_.sampler);
}

LightDirection LightSampler::at(const glm::dvec3& direction) const {
    const double luminance_nt = luminance_nt_ * light_.luminance_share_at(receiver_, direction);
    if (class_of(light_.shape) == ShapeClass::sun) return {luminance_nt, std::numeric_limits<double>::infinity()};
    // A ray along a direction on the outline may miss because of rounding; from inside nothing is in between.
    const std::optional<double> distance = distance_to(light_, {receiver_, direction});
    const glm::dvec3 to_center = light_.frame.origin - receiver_;
    return {luminance_nt, distance.value_or(std::max(glm::dot(direction, to_center), 0.0))};
}

} // namespace gonio::detail
