// Environments and directions to test them with.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/sky/environment_map.hpp>
#include <gonio/sky/environment_resample.hpp>
#include <gonio/sky/sky.hpp>
#include <gonio/sky/sky_description.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace gonio::test {

inline EnvironmentMap filled(const EnvironmentGrid& grid, float value) {
    Image image(grid.width(), grid.height(), 3);
    std::fill(image.pixels.begin(), image.pixels.end(), value);
    return EnvironmentMap::of_valid(grid, std::move(image), 1.0);
}

inline EnvironmentMap sky_map(const std::string& text, EnvironmentLayout layout, int side) {
    return rendered(*resolve_sky(*parse_sky_description(text)), *environment_grid(layout, side));
}

// With equal shares of the sphere: on a spiral of the golden angle.
inline std::vector<glm::dvec3> directions(int count) {
    std::vector<glm::dvec3> all;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double r = std::sqrt((1.0 - z) * (1.0 + z));
        const double azimuth = std::numbers::pi * (3.0 - std::sqrt(5.0)) * i;
        all.emplace_back(r * std::cos(azimuth), r * std::sin(azimuth), z);
    }
    return all;
}

} // namespace gonio::test
