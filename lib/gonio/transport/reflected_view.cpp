#include <gonio/transport/exchange_geometry.hpp>
#include <gonio/transport/reflected_view.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gonio::detail {

ReflectedView::ReflectedView(const ExchangeGeometry& geometry, const Interreflection* indirect, const BlurredSky* sky,
                             simd::InstructionSet set)
    : geometry_(geometry), indirect_(indirect), sky_(sky), caster_(geometry.stage(), geometry.patches(), set) {
    for (const Chart& chart : geometry.patches().charts().all())
        width_m_.push_back(static_cast<float>(chart.kind == Chart::Kind::round
                                                  ? 2.0 * chart.radius
                                                  : std::min(chart.u.high - chart.u.low, chart.v.high - chart.v.low)));
}

const std::vector<glm::vec3>& ReflectedView::luminance(const SurfaceSamples& samples, std::size_t first,
                                                       std::size_t count, const LobeRays& lobe) {
    luminance_.assign(count, glm::vec3(0.0F));
    // Room for all rays; those without weight are left out.
    const std::size_t most = count * lobe.count();
    for (auto* const axes : {&origin_, &direction_})
        for (std::vector<float>& axis : *axes)
            axis.resize(most);
    weight_.resize(most);
    ray_width_.resize(most);
    of_sample_.resize(most);
    std::size_t rays = 0;
    const double lift_m = Patches::lift(geometry_.patches().square_m());
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 normal = glm::normalize(samples.normal_of(first + i));
        const glm::dvec3 view = samples.view_of(first + i);
        const double cosine = glm::dot(normal, view);
        if (!(cosine > 0.0)) continue;
        lobe.at(cosine, rays_);
        const glm::dvec3 aside = view - cosine * normal;
        const double length = glm::length(aside);
        const glm::vec3 x(length > 1e-9 ? aside / length : frame_about(glm::dvec3(0.0), normal).x);
        const glm::vec3 z(normal);
        const glm::vec3 y = glm::cross(z, x);
        const glm::vec3 origin(samples.position_of(first + i) - samples.anchor + lift_m * normal);
        for (const LobeRay& ray : rays_) {
            if (ray.weight == glm::vec3(0.0F)) continue;
            const glm::vec3 direction = ray.direction.x * x + ray.direction.y * y + ray.direction.z * z;
            for (int axis = 0; axis < 3; ++axis) {
                origin_[static_cast<std::size_t>(axis)][rays] = origin[axis];
                direction_[static_cast<std::size_t>(axis)][rays] = direction[axis];
            }
            weight_[rays] = ray.weight;
            ray_width_[rays] = ray.width;
            of_sample_[rays] = static_cast<std::uint32_t>(i);
            ++rays;
        }
    }
    caster_.cast(samples.anchor, geometry_.own(samples.surface), origin_, direction_, rays, ends_);
    // A single ray that meets a thing much narrower than the distance between rays would draw a line: it counts less,
    // and the others more.
    all_.assign(count, glm::vec3(0.0F));
    kept_.assign(count, glm::vec3(0.0F));
    for (std::size_t i = 0; i < rays; ++i) {
        const std::uint32_t sample = of_sample_[i];
        all_[sample] += weight_[i];
        if (ends_[i].chart == no_patch || ends_[i].chart == back_side) {
            kept_[sample] += weight_[i];
            if (sky_ != nullptr && ends_[i].chart == no_patch)
                luminance_[sample] +=
                    weight_[i] * glm::vec3(sky_->radiance({direction_[0][i], direction_[1][i], direction_[2][i]},
                                                          1.5F * ray_width_[i]));
            continue;
        }
        const float between_m = ray_width_[i] * ends_[i].distance_m;
        const float width_m = width_m_[ends_[i].chart];
        const glm::vec3 weight = width_m < between_m ? width_m / between_m * weight_[i] : weight_[i];
        kept_[sample] += weight;
        if (indirect_ != nullptr)
            luminance_[sample] +=
                weight * indirect_->luminance_at(ends_[i], between_m,
                                                 -glm::vec3(direction_[0][i], direction_[1][i], direction_[2][i]));
    }
    for (std::size_t i = 0; i < count; ++i)
        for (int channel = 0; channel < 3; ++channel)
            if (kept_[i][channel] > 0.0F) luminance_[i][channel] *= all_[i][channel] / kept_[i][channel];
    return luminance_;
}

} // namespace gonio::detail
