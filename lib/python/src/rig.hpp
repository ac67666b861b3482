// Rigs, and stages with the materials that a caller gives them.
#pragma once

#include <gonio/scene/rig.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/transport/lighting_options.hpp>

#include "binding.hpp"
#include "sky_types.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gonio::python {

// A rig with its lights resolved.
struct LoadedRig {
    Rig rig;
    std::vector<Light> lights; // and the surfaces that emit, and the sun of its sky
    Stage stage;               // with the rig's materials and what its surfaces emit
    std::optional<LoadedSky> sky;
    Diagnostics diagnostics;
};

// The stage of that name; without one that of the rig, or the first of the stages.
Stage stage_of(const py::object& lights, const std::optional<std::string>& name,
               const std::map<std::string, std::string>& materials);

// A sky that is given, else that of a rig, else none. Its sun is added to `lights` if it is given: a rig has it
// already.
LoadedSky sky_over(const py::object& of, const std::optional<py::object>& given, std::vector<Light>& lights);

Shadows shadows_named(const std::string& name);

// −1: until the light is absorbed.
int bounces_of(int number);

} // namespace gonio::python
