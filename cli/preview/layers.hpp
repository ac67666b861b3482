// `gonio preview --aov`: what a picture is the sum of, as layers of one OpenEXR file.
#pragma once

#include <gonio/base/result.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"

#include <array>

namespace gonio::cli {

inline constexpr std::array preview_layer_options{
    Option{"--aov", "LIST",
           "layers of an .exr beside the picture: lights (each by its name), parts (emission, diffuse, specular), "
           "illuminance (lx)",
           "layers"},
};

struct LayerKind {
    std::string_view name;
    std::string_view summary;
};
inline constexpr std::array layer_kinds{
    LayerKind{"lights", "the share of each light by its name: they add up to the picture"},
    LayerKind{"parts", "emission, diffuse and specular: they add up to the picture"},
    LayerKind{"illuminance", "lx at what is seen; with lights, of each too"},
};

// The picture itself has no layer's name (R, G, B): programs that know no layers show it. Returns the exit status.
Result<int> preview_layers(const Arguments& arguments, Console& console);

} // namespace gonio::cli
