// Texture: a web laid out on a grid of texels, with what is needed to know what a texel means.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>

#include <span>
#include <string>
#include <string_view>

namespace gonio {

// What a texel of 1 stands for.
enum class Normalization {
    none, // 1 cd
    peak, // the web's greatest intensity
    mean, // the web's mean over the whole sphere, Φ/4π
    flux  // the web's flux: candela per lumen
};

const char* to_text(Normalization normalization); // "peak"

// Fails (usage) on an unknown name.
Result<Normalization> parse_normalization(std::string_view text);

std::span<const std::string_view> normalization_names();

struct Texture {
    std::string layout;           // "latlong"
    std::string texel_convention; // one sentence: which directions a texel stands for, and what of them it holds
    Image image;                  // one channel
    Normalization normalization = Normalization::none;
    double cd_per_unit = 1.0; // candela = texel × cd_per_unit
    Candelas peak;            // of the web
    Lumens flux;              // of the web
    Lumens texture_flux;      // of the texels as stored, each over its own solid angle
    Candelas max_error;       // greatest |filtered texture − web|, over the texel centres and the web's grid
};

} // namespace gonio
