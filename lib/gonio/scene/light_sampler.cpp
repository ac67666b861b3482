#include <gonio/scene/detail/core_vector.hpp>
#include <gonio/scene/detail/light_sampler.hpp>
#include <gonio/scene/emitter.hpp>
#include <gonio/shading/falloff.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gonio::detail {

namespace {

using Vec = shading::vec3<double>;

// Whether the receiver is before a side that shines, or in its plane: what is seen there the sampler says.
bool shines_on(const Light& light, const glm::dvec3& to_center) {
    const auto before = [&](bool two_sided) {
        const double height = glm::dot(to_center, light.frame.z); // the light shines along −Z
        return height >= 0.0 || two_sided;
    };
    if (const auto* disk = std::get_if<DiskShape>(&light.shape)) return before(disk->two_sided);
    if (const auto* rect = std::get_if<RectShape>(&light.shape)) return before(rect->two_sided);
    return true;
}

} // namespace

LightSampler::Sampler LightSampler::sampler_of(const Light& light, const glm::dvec3& to_center) {
    const Vec center = vec(to_center);
    const Vec axis = vec(-light.frame.z);
    if (const auto* s = std::get_if<DiskShape>(&light.shape))
        return shading::DiskSampler<double>(center, axis, s->radius.value);
    if (const auto* s = std::get_if<RectShape>(&light.shape))
        return shading::RectangleSampler<double>(center, axis, vec(light.frame.x), s->width.value, s->height.value);
    if (const auto* s = std::get_if<TubeShape>(&light.shape))
        return shading::TubeSampler<double>(center, vec(light.frame.x), s->radius.value, s->length.value);
    if (const auto* s = std::get_if<SunShape>(&light.shape))
        return shading::SphereSampler<double>(vec(light.frame.z), std::sin(0.5 * s->diameter.value));
    return shading::SphereSampler<double>(center, std::get<SphereShape>(light.shape).radius.value);
}

LightSampler::LightSampler(const Light& light, const glm::dvec3& receiver)
    : light_(light),
      mask_(mask_of(light.shape).web),
      receiver_(receiver),
      sampler_(sampler_of(light, light.frame.origin - receiver)) {
    const glm::dvec3 to_center = light.frame.origin - receiver;
    if (!shines_on(light, to_center)) return;
    const bool windowed = light.range && !std::holds_alternative<SunShape>(light.shape);
    luminance_nt_ = light.luminance.value *
                    (windowed ? shading::window_squared(glm::length(to_center), 1.0 / light.range->value) : 1.0);
}

shading::LightSample<double> LightSampler::sample(double u0, double u1) const {
    if (!(luminance_nt_ > 0.0)) return {{0.0, 0.0, 1.0}, 0.0};
    return std::visit([&](const auto& sampler) { return sampler.sample(u0, u1); }, sampler_);
}

double LightSampler::pdf(Vec direction) const {
    if (!(luminance_nt_ > 0.0)) return 0.0;
    return std::visit([&](const auto& sampler) { return sampler.pdf(direction); }, sampler_);
}

LightDirection LightSampler::at(const glm::dvec3& direction) const {
    const double mask =
        mask_ == nullptr ? 1.0 : std::max(light_.web_scale * mask_->candela(light_.frame.to_local(-direction)), 0.0);
    if (std::holds_alternative<SunShape>(light_.shape))
        return {luminance_nt_ * mask, std::numeric_limits<double>::infinity()};
    // A direction on the outline may miss by rounding; from inside nothing is in between.
    const std::optional<double> distance = distance_to(light_, {receiver_, direction});
    const glm::dvec3 to_center = light_.frame.origin - receiver_;
    return {luminance_nt_ * mask, distance.value_or(std::max(glm::dot(direction, to_center), 0.0))};
}

} // namespace gonio::detail
