#include <gonio/figures/glare.hpp>
#include <gonio/figures/position_index.hpp>
#include <gonio/light/projected_area.hpp>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <variant>

namespace gonio {

namespace {

constexpr double small_area_m2 = 0.005;
constexpr double large_solid_angle_sr = 0.1;

// The area that a light shows along a world direction; empty for a light without a size.
std::optional<double> shown_area_m2(const Light& light, const glm::dvec3& direction) {
    if (const auto* profile = std::get_if<ProfileShape>(&light.shape)) {
        const Opening* const opening = profile->given != nullptr ? profile->given.get() : profile->declared.get();
        if (opening == nullptr || opening->shape == OpeningShape::point) return std::nullopt;
        return projected_area_m2(*opening, light.frame.to_local(direction));
    }
    if (!(light.luminance.value > 0.0)) return std::nullopt;
    const double share = light.luminance_share(direction);
    return share > 0.0 ? light.intensity_towards(direction).value / (light.luminance.value * share) : 0.0;
}

} // namespace

std::optional<GlareShare> glare_share(const Light& light, const Observer& observer) {
    GlareShare share;
    if (std::holds_alternative<SunShape>(light.shape)) return share;
    const glm::dvec3 view = glm::normalize(observer.view);
    const glm::dvec3 side = glm::normalize(glm::cross(view, glm::dvec3(0.0, 0.0, 1.0)));
    const glm::dvec3 up = glm::cross(side, view);
    const glm::dvec3 towards = light.frame.origin - observer.eye;
    const double distance_m = glm::length(towards);
    const double ahead_m = glm::dot(towards, view);
    if (!(distance_m > 0.0)) return share;
    const glm::dvec3 from_light = -towards / distance_m;
    const std::optional<double> area_m2 = shown_area_m2(light, from_light);
    if (!area_m2) return std::nullopt;
    const double intensity_cd = light.intensity_towards(from_light).value;
    if (!(ahead_m > 0.0 && intensity_cd > 0.0)) return share;
    share.is_small = *area_m2 < small_area_m2;
    const double counted_m2 = share.is_small ? small_area_m2 : *area_m2;
    share.luminance = Nits(intensity_cd / counted_m2);
    share.solid_angle_sr = counted_m2 / (distance_m * distance_m);
    share.is_too_large = share.solid_angle_sr > large_solid_angle_sr;
    share.position_index = closed_position_index(glm::dot(towards, side), ahead_m, glm::dot(towards, up));
    share.sum = share.luminance.value * share.luminance.value * share.solid_angle_sr /
                (share.position_index * share.position_index);
    return share;
}

GlareRating glare_rating(std::span<const Light> lights, const Observer& observer, std::span<const double> visible,
                         double background_lx) {
    GlareRating rating;
    rating.background = Nits(background_lx / std::numbers::pi);
    double sum = 0.0;
    bool has_point = false;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const std::optional<GlareShare> share = glare_share(lights[i], observer);
        has_point = has_point || !share;
        rating.lights.push_back(share.value_or(GlareShare()));
        GlareShare& seen = rating.lights.back();
        seen.sum *= visible[i];
        sum += seen.sum;
        rating.has_too_large = rating.has_too_large || (seen.is_too_large && seen.sum > 0.0);
    }
    if (!has_point && sum > 0.0 && background_lx > 0.0) rating.ugr = unified_glare_rating(sum, rating.background);
    return rating;
}

double unified_glare_rating(double sum_of_shares, Nits background) {
    return 8.0 * std::log10(0.25 / background.value * sum_of_shares);
}

} // namespace gonio
