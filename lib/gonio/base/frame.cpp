#include <gonio/base/frame.hpp>

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace gonio {

glm::dvec3 direction_of(PolarAngles angles) {
    const double sin_gamma = std::sin(angles.gamma.value);
    return {sin_gamma * std::cos(angles.c.value), sin_gamma * std::sin(angles.c.value), -std::cos(angles.gamma.value)};
}

PolarAngles angles_of(const glm::dvec3& direction) {
    // atan2 keeps full accuracy at the poles, where acos of the cosine loses half the digits.
    const double across = std::hypot(direction.x, direction.y);
    double c = across > 0.0 ? std::atan2(direction.y, direction.x) : 0.0;
    if (c < 0.0) c += 2.0 * std::numbers::pi;
    if (c >= 2.0 * std::numbers::pi) c = 0.0;
    return {Radians(c), Radians(std::atan2(across, -direction.z))};
}

Frame aimed_frame(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& up) {
    Frame frame;
    frame.origin = origin;
    frame.z = -glm::normalize(direction);
    for (const glm::dvec3& candidate : {up, glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) {
        const double length = glm::length(candidate);
        if (!(length > 0.0)) continue;
        const glm::dvec3 unit = candidate / length;
        const glm::dvec3 across = glm::cross(unit, frame.z);
        // An angle below 1e-6 rad to the axis counts as parallel: the rest of `up` would be rounding.
        if (glm::length(across) < 1e-6) continue;
        frame.x = glm::normalize(across);
        frame.y = glm::cross(frame.z, frame.x);
        break;
    }
    return frame;
}

} // namespace gonio
