// Directions in the sky, as surveyors and almanacs state them.
//
// z is up, +Y is north and +X is east. The azimuth counts from north over east: 0° is +Y, 90° is +X, 180° is −Y. Seen
// from above it runs clockwise, against the C angle of a photometric web. The elevation is that above the horizon.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>

#include <glm/vec3.hpp>

#include <cmath>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// A direction on the sky: the azimuth from north over east, the elevation above the horizon.
struct SkyAngles {
    double azimuth_deg = 0.0;
    double elevation_deg = 0.0;
};

// Unit vector; any angles.
inline glm::dvec3 direction_of(const SkyAngles& at) {
    const double azimuth = degrees(at.azimuth_deg).value;
    const double elevation = degrees(at.elevation_deg).value;
    return {std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation), std::sin(elevation)};
}

// "180/40": azimuth and elevation in degrees, with or without the unit. `what` names the direction in messages. Fails
// (usage) on anything else and on an elevation outside [−90, 90].
Result<SkyAngles> parse_sky_angles(std::string_view text, std::string_view what);

// Of a vector of any length > 0: azimuth in [0, 360), elevation in [−90, 90]. At the poles, where the azimuth has no
// meaning, it is 0.
inline SkyAngles sky_angles_of(const glm::dvec3& direction) {
    const double flat = std::hypot(direction.x, direction.y);
    const double elevation_deg = to_degrees(Radians(std::atan2(direction.z, flat)));
    if (flat == 0.0) return {0.0, elevation_deg};
    const double azimuth_deg = to_degrees(Radians(std::atan2(direction.x, direction.y)));
    const double positive_deg = azimuth_deg < 0.0 ? azimuth_deg + 360.0 : azimuth_deg;
    return {positive_deg < 360.0 ? positive_deg : 0.0, elevation_deg};
}

// The direction, turned about z so that its azimuth grows by `angle`.
inline glm::dvec3 turned(const glm::dvec3& direction, Radians angle) {
    const double c = std::cos(angle.value);
    const double s = std::sin(angle.value);
    return {c * direction.x + s * direction.y, c * direction.y - s * direction.x, direction.z};
}

} // namespace gonio
#pragma GCC visibility pop
