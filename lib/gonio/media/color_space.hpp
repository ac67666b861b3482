// Scene-linear colour spaces of OpenColorIO configurations, as matrices.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/color/rgb_space.hpp>

#include <glm/mat3x3.hpp>

#include <string>

namespace gonio::media {

struct SceneLinearSpace {
    std::string name;                // as in the configuration, if an alias or a role was requested
    glm::dmat3 from_aces2065_1{1.0}; // RGB of ACES2065-1 → RGB of the space
    bool exact = true;               // the configuration's own matrix in double; else measured in float32
};

// The space of a name, alias or role; `config` is a file, empty: the built-in configuration. Entered through the role
// aces_interchange, never through the display-referred cie_xyz_d65_interchange, because a configuration may apply a
// tone map there. Opens the module gonio-color.so. Fails (io, malformed) on a configuration that cannot be read;
// (usage) on an unknown name; (unsupported) without the module or that role, and on a space that is not a scene-linear
// space.
Result<SceneLinearSpace> scene_linear_space(const std::string& name, const std::string& config = {});

// The same as a space with its matrices to and from XYZ. Without a configuration, the hint for an unknown name is the
// nearest of the built-in spaces of rgb_space.hpp, which are not looked up here.
Result<RgbSpace> rgb_space_of_config(const std::string& name, const std::string& config = {});

} // namespace gonio::media
