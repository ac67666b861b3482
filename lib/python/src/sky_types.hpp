// Skies, environment images and suns as Python holds them.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/sky/environment_map.hpp>
#include <gonio/sky/sky.hpp>
#include <gonio/sky/sky_description.hpp>
#include <gonio/sky/sun_light.hpp>

#include "binding.hpp"

#include <memory>
#include <optional>
#include <string>

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

} // namespace gonio::python
