// A rig of the lights that were found in a scene.
#pragma once

#include <gonio/interchange/found_light.hpp>

#include <functional>
#include <string>

#pragma GCC visibility push(default)
namespace gonio {

// The JSON of schema gonio.rig/1, one light a line; lights that are only listed are left out. `profile_file` names the
// file of a light's profile, relative to the rig.
std::string scene_rig(const FoundScene& scene, const std::function<std::string(const FoundLight& light)>& profile_file);

// The shape as the text of its grammar: "rect:w=0.6m,h=0.3m". Every number reads back as the same double, but for
// angles, which are in degrees.
std::string shape_text(const Shape& shape);

} // namespace gonio
#pragma GCC visibility pop
