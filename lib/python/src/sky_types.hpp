// Skies, environment images and suns as Python holds them.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/sky/environment_map.hpp>
#include <gonio/sky/sky.hpp>
#include <gonio/sky/sky_description.hpp>
#include <gonio/sky/sun_light.hpp>

#include "binding.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gonio::python {

struct Environment {
    std::shared_ptr<const EnvironmentMap> map;
    Diagnostics diagnostics; // of making or reading it
};

Environment environment_of(EnvironmentMap&& map);

// A grid by its size in pixels, else the usual one of the layout. Fails as EnvironmentGrid::create() and
// environment_grid() do.
EnvironmentGrid grid_of(const std::string& layout, std::optional<std::pair<int, int>> size);

// The picture of a sky that is an image, from its file.
Environment read_environment(const ImageSkyKind& kind);

struct LoadedSky {
    std::string text; // as it was described
    Sky sky;          // without its sun
    Diagnostics diagnostics;
};

// With the image of its file, if it is one.
LoadedSky load_sky(SkyDescription description, std::string text);

// A sky as a text, an environment or a sky.
LoadedSky sky_of(const py::object& sky);

// What lights a stage: the sun beside a sky.
Light light_of(const SunLight& sun, const std::string& name);

// The photometric part of linear Rec.709, in its unit.
inline double luminance_of(const glm::dvec3& rgb) {
    return glm::dot(rgb, rec709_luminance);
}

// Illuminance [lx] (…) of open planes with normals (…, 3) of any length, under a Sky or an EnvironmentMap.
template<class Source>
py::object illuminance_under(const Source& source, const Doubles& normals, unsigned threads) {
    require_vectors(normals, "normals");
    std::vector<glm::dvec3> list(static_cast<std::size_t>(normals.size()) / 3);
    const double* from = normals.data();
    for (glm::dvec3& normal : list) {
        normal = direction_of_length({from[0], from[1], from[2]}, "a normal");
        from += 3;
    }
    const auto lux = interruptible([&] { return source.irradiance(list, threads); });
    Doubles result(shape_of_vectors(normals));
    for (std::size_t i = 0; i < lux.size(); ++i)
        result.mutable_data()[i] = luminance_of(lux[i]);
    return number_or_array(result);
}

} // namespace gonio::python
