#include <gonio/figures/disability_glare.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio {

namespace {

constexpr double least_angle_deg = 1.5;
constexpr double greatest_angle_deg = 60.0;

} // namespace

Nits veiling_luminance(const Light& light, const Observer& observer, double age_years) {
    const glm::dvec3 view = glm::normalize(observer.view);
    const glm::dvec3 path = light.frame.origin - observer.eye;
    const double squared_m2 = glm::dot(path, path);
    if (!(squared_m2 > 0.0)) return {};
    const double distance_m = std::sqrt(squared_m2);
    const double cosine = glm::dot(path, view) / distance_m;
    const double angle_deg =
        std::atan2(glm::length(glm::cross(path, view)) / distance_m, cosine) * 180.0 / std::numbers::pi;
    if (angle_deg < least_angle_deg || angle_deg > greatest_angle_deg) return {};
    const double eye_lx = light.intensity_towards(-path).value * cosine / squared_m2;
    const double age = age_years / 66.4;
    return Nits(9.86 * (1.0 + age * age * age * age) * eye_lx / (angle_deg * angle_deg));
}

Nits veiling_luminance(std::span<const Light> lights, const Observer& observer, double age_years) {
    Nits sum;
    for (const Light& light : lights)
        sum = sum + veiling_luminance(light, observer, age_years);
    return sum;
}

std::optional<double> threshold_increment(Nits veil, Nits road) {
    if (!(road.value > 0.05)) return std::nullopt;
    return road.value <= 5.0 ? 65.0 * veil.value / std::pow(road.value, 0.8)
                             : 95.0 * veil.value / std::pow(road.value, 1.05);
}

double field_glare_rating(Nits veil, Lux mean, double reflectance) {
    const double field_nt = 0.035 * mean.value * reflectance / std::numbers::pi;
    return 27.0 + 24.0 * (std::log10(veil.value) - 0.9 * std::log10(field_nt));
}

double greatest_field_glare_rating(std::span<const Light> lights, std::span<const glm::dvec3> points, Lux mean,
                                   double reflectance) {
    constexpr int directions = 24;
    constexpr double dip = 2.0 * std::numbers::pi / 180.0;
    Nits greatest;
    for (const glm::dvec3& point : points)
        for (int i = 0; i < directions; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / directions;
            const Observer player{point + glm::dvec3(0.0, 0.0, 1.5),
                                  {std::cos(angle) * std::cos(dip), std::sin(angle) * std::cos(dip), -std::sin(dip)}};
            greatest.value = std::max(greatest.value, veiling_luminance(lights, player).value);
        }
    return field_glare_rating(greatest, mean, reflectance);
}

} // namespace gonio
