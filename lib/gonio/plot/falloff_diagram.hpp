// The falloff diagram: the illuminance that lights give on their axis, against the distance.
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

// Lux against metres, both logarithmic: a receiver that faces the light, along its direction from its centre, by the
// light's exact form and with the window of its range. Dashed, the inverse square of the intensity that the light has
// there from far away; dotted, what the window took away. Distances inside a light, or on it, are left out.
// Fails (usage) on a page or distances out of range, without lights, on a sun (it has no distance) and on a
// light that is dark along its direction.
Result<Drawing> falloff_diagram(std::span<const PlottedLight> lights, const FalloffOptions& options);

} // namespace gonio
