// The falloff diagram: the illuminance from lights along their axis, against the distance.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/plot/drawing.hpp>

#include <span>
#include <string>

namespace gonio {

struct PlottedLight {
    std::string label; // UTF-8
    Light light;
};

struct FalloffOptions {
    int width_px = 720;
    int height_px = 720;
    std::string title;
    double nearest_m = 0.1; // from the light's centre
    double farthest_m = 20.0;
};

// Lux against metres, both logarithmic: for a receiver that faces the light, along the light's direction from its
// centre, by the exact form of the light and with the window of its range. Dashed: the inverse square of the light's
// far-field intensity in that direction. Dotted: the illuminance without the window. Distances inside a light, or on
// its surface, are left out. Fails (usage) on a page or distances out of range, without lights, on a sun (it has no
// distance) and on a light that is dark along its direction.
Result<Drawing> falloff_diagram(std::span<const PlottedLight> lights, const FalloffOptions& options);

} // namespace gonio
