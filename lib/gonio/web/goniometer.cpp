#include <gonio/base/frame.hpp>
#include <gonio/web/goniometer.hpp>

#include <cmath>
#include <numbers>

namespace gonio {

namespace {

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

// A direction in components: along the polar axis, and the two others; `ahead` is longitude 0.
struct Polar {
    double along;
    double across;
    double ahead;
};

double latitude_deg(const Polar& p) {
    return std::atan2(p.along, std::hypot(p.across, p.ahead)) * degrees_per_radian;
}

double longitude_deg(const Polar& p) {
    return p.across == 0.0 && p.ahead == 0.0 ? 0.0 : std::atan2(p.across, p.ahead) * degrees_per_radian;
}

} // namespace

glm::dvec3 direction_of(Photometry type, GoniometerAngles angles) {
    const double h = angles.horizontal_deg / degrees_per_radian;
    const double v = angles.vertical_deg / degrees_per_radian;
    switch (type) {
    case Photometry::a:
        return {std::cos(v) * std::sin(h), std::sin(v), -std::cos(v) * std::cos(h)};
    case Photometry::b:
        return {std::sin(h), std::cos(h) * std::sin(v), -std::cos(h) * std::cos(v)};
    case Photometry::c:
        break;
    }
    return direction_of({Radians(h), Radians(v)});
}

GoniometerAngles angles_of(Photometry type, const glm::dvec3& direction) {
    switch (type) {
    case Photometry::a: {
        const Polar polar{direction.y, direction.x, -direction.z};
        return {longitude_deg(polar), latitude_deg(polar)};
    }
    case Photometry::b: {
        const Polar polar{direction.x, direction.y, -direction.z};
        return {latitude_deg(polar), longitude_deg(polar)};
    }
    case Photometry::c:
        break;
    }
    const PolarAngles polar = angles_of(direction);
    return {to_degrees(polar.c), to_degrees(polar.gamma)};
}

} // namespace gonio
