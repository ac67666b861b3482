// `gonio preview --aov`: the contributions that add up to a picture, as layers of one OpenEXR file.
#pragma once

#include <gonio/base/result.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"

#include <array>

namespace gonio::cli {

inline constexpr std::array preview_layer_options{
    Option{"--aov", "LIST",
           "add layers to the .exr: lights (one for each, by name), parts (emission, diffuse, specular), direct and "
           "indirect, "
           "illuminance (lx)",
           "layers"},
};

struct LayerKind {
    std::string_view name;
    std::string_view summary;
};
inline constexpr std::array layer_kinds{
    LayerKind{"lights", "one layer for each light, by name; they add up to the picture"},
    LayerKind{"parts", "emission, diffuse and specular; they add up to the picture"},
    LayerKind{"direct", "light that no surface has reflected before; with indirect it adds up to the picture"},
    LayerKind{"indirect", "light that bounced between the surfaces of the stage"},
    LayerKind{"illuminance", "lx on what is seen; with lights, also from each light"},
};

// The picture itself has no layer name (R, G, B), so that programs that do not know layers show it. Returns the exit
// status.
Result<int> preview_layers(const Arguments& arguments, Console& console);

} // namespace gonio::cli
