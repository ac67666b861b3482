// Texture: a web laid out on a grid of texels, with the meaning of a texel.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace gonio {

// The meaning of a texel of 1.
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

// The stored type of a texel. Integers hold [0, 1] on their whole range.
enum class TexelType { float32, half, uint16, uint8 };

// What becomes of `value` ≥ 0 when it is stored, read back: rounded to nearest (to a half by way of a float), cut to
// [0, 1] by integers. A half beyond 65504 is infinite.
double as_stored(TexelType type, double value);

// What a texel holds of the directions around it.
enum class Sampling {
    mean,         // the exact mean over its solid angle
    left_edge,    // the value at its left edge, in the middle of its row; one row: the mean over C there
    edge_columns, // the value at i/(width − 1), in the middle of its row: the outermost columns lie on the edges
    corners       // the value at i/(width − 1), j/(height − 1): the outermost texels lie on the edges
};

const char* to_text(Sampling sampling); // "left-edge"

// How a stored number stands for a value: itself, or encoded as sRGB does (IEC 61966-2-1).
enum class Transfer { linear, srgb };

const char* to_text(Transfer transfer); // "srgb"

// On [0, 1]; linear leaves any value alone.
double encoded(Transfer transfer, double value);
double decoded(Transfer transfer, double value);

struct Texture {
    std::string layout;           // "latlong"
    std::string texel_convention; // one sentence: which directions a texel stands for, and what of them it holds
    Image image;                  // one channel
    Normalization normalization = Normalization::none;
    double cd_per_unit = 1.0; // candela = texel × cd_per_unit
    Candelas peak;            // of the web
    Lumens flux;              // of the web
    TexelType texel_type = TexelType::float32;
    Sampling sampling = Sampling::mean;
    Transfer transfer = Transfer::linear; // of the file; `image` holds what it decodes to
    Lumens texture_flux;                  // of the texels as stored, each over its own solid angle
    Candelas quantization_error;          // greatest |texel as stored − its mean|, negative means as 0
    Steradians solid_angle;               // of all texels: 4π unless the layout leaves directions out
    Candelas max_error;        // greatest |texture, filtered, − web| at the texels' centres and at the web's grid
    Candelas least_mean;       // the least of the texels' means where one is negative, and stored as 0; else 0
    std::size_t texels = 0;    // of the layout: borders and empty corners left out
    std::size_t evaluated = 0; // texels whose mean was computed; the others are mirror images, or dark
};

// What a file holds: `width` columns from `x` on, each texel repeated in `channels`, encoded as its transfer says.
Image picture_of(const Texture& texture, int x, int width, int channels);

} // namespace gonio
