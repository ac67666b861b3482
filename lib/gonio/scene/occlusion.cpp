#include <gonio/scene/occlusion.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio {

namespace {

double safe_acos(double x) {
    return std::acos(std::clamp(x, -1.0, 1.0));
}

// 2π(1−cos a) without cancellation.
double cap_area(double a) {
    const double s = std::sin(0.5 * a);
    return 4.0 * std::numbers::pi * s * s;
}

double lens_area(double a, double b, double d) {
    const double from_a = safe_acos((d * d + a * a - b * b) / (2.0 * d * a));
    const double from_b = safe_acos((d * d + b * b - a * a) / (2.0 * d * b));
    return a * a * (from_a - 0.5 * std::sin(2.0 * from_a)) + b * b * (from_b - 0.5 * std::sin(2.0 * from_b));
}

// The angle opposite side x of a spherical triangle with sides x, y, z, by its half: keeps its digits in small
// triangles, where the law of cosines loses them.
double triangle_angle(double x, double y, double z) {
    const double s = 0.5 * (x + y + z);
    const double up = std::max(std::sin(s - y) * std::sin(s - z), 0.0);
    const double down = std::max(std::sin(s) * std::sin(s - x), 0.0);
    return 2.0 * std::atan2(std::sqrt(up), std::sqrt(down));
}

double angle_between(const glm::dvec3& p, const glm::dvec3& q) {
    return std::atan2(glm::length(glm::cross(p, q)), glm::dot(p, q));
}

} // namespace

double cap_overlap(double a, double b, double d) {
    const double small = std::min(a, b);
    if (d >= a + b) return 0.0;
    if (d <= std::abs(a - b)) return cap_area(small);
    if (std::max(a, b) < 1e-4) return std::min(lens_area(a, b, d), cap_area(small));
    const double at_crossing = triangle_angle(d, a, b);
    const double at_a = triangle_angle(b, d, a);
    const double at_b = triangle_angle(a, d, b);
    const double area = 2.0 * (std::numbers::pi - at_crossing - at_a * std::cos(a) - at_b * std::cos(b));
    return std::clamp(area, 0.0, cap_area(small));
}

double visible_share(const Stage& stage, std::size_t own, const glm::dvec3& point, const glm::dvec3& light_center,
                     double light_radius) {
    const glm::dvec3 to_light = light_center - point;
    const double light_distance = glm::length(to_light);
    if (!(light_distance > light_radius)) return 1.0;
    double share = 1.0;
    for (std::size_t i = 0; i < stage.surfaces.size() && share > 0.0; ++i) {
        const auto* ball = std::get_if<Ball>(&stage.surfaces[i].geometry);
        if (ball == nullptr || i == own) continue;
        const glm::dvec3 to_ball = ball->center - point;
        const double ball_distance = glm::length(to_ball);
        // Touching is not covering, and what is behind the light casts nothing on us.
        if (!(ball_distance > ball->radius) || ball_distance >= light_distance) continue;
        const double ball_angle = std::asin(ball->radius / ball_distance);
        const double apart = angle_between(to_light, to_ball);
        if (light_radius <= 0.0) {
            if (apart < ball_angle) share = 0.0;
            continue;
        }
        const double light_angle = std::asin(light_radius / light_distance);
        share *= 1.0 - cap_overlap(light_angle, ball_angle, apart) / cap_area(light_angle);
    }
    return std::max(share, 0.0);
}

} // namespace gonio
