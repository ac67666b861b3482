// Texture: a web laid out on a grid of texels, with the meaning of a texel.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
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

// The names that parse_normalization() takes.
std::span<const std::string_view> normalization_names();

// The stored type of a texel. Integers map [0, 1] to their full range.
enum class TexelType { float32, half, uint16, uint8 };

// `value` ≥ 0 after it is stored and read back: rounded to nearest (to a half by way of a float), clipped to [0, 1] for
// integers. A half beyond 65504 is infinite.
double as_stored(TexelType type, double value);

// What a texel stores of the directions around it.
enum class Sampling {
    mean,         // the exact mean over its solid angle
    left_edge,    // the value at its left edge, in the middle of its row; one row: the mean over C there
    edge_columns, // the value at i/(width − 1), in the middle of its row: the outermost columns lie on the edges
    corners       // the value at i/(width − 1), j/(height − 1): the outermost texels lie on the edges
};

const char* to_text(Sampling sampling); // "left-edge"

// How a stored number represents a value: itself, or encoded as in sRGB (IEC 61966-2-1).
enum class Transfer { linear, srgb };

const char* to_text(Transfer transfer); // "srgb"

// On [0, 1]; linear leaves every value unchanged.
double encoded(Transfer transfer, double value);
double decoded(Transfer transfer, double value);

// A baked texture and what its numbers mean.
struct Texture {
    std::string layout;           // "latlong"
    std::string texel_convention; // one sentence: which directions a texel covers, and what it stores of them
    Image image;                  // one channel
    Normalization normalization = Normalization::none;
    double cd_per_unit = 1.0; // candela = texel × cd_per_unit
    Candelas peak;            // of the web
    Lumens flux;              // of the web
    TexelType texel_type = TexelType::float32;
    Sampling sampling = Sampling::mean;
    Transfer transfer = Transfer::linear; // of the file; `image` holds the decoded values
    Lumens texture_flux;                  // of the texels as stored, each over its own solid angle
    Candelas quantization_error;          // greatest |texel as stored − its mean|, negative means as 0
    Steradians solid_angle;               // of all texels: 4π unless the layout leaves directions out
    Candelas max_error;        // greatest |texture, filtered, − web| at the texels' centres and at the web's grid
    Candelas least_mean;       // the least of the texels' means if one is negative (stored as 0); else 0
    std::size_t texels = 0;    // of the layout, without borders and empty corners
    std::size_t evaluated = 0; // texels whose mean was computed; the others are mirror images, or dark
};

// The content of a file: `width` columns starting at `x`, each texel repeated in `channels`, encoded with its transfer.
Image picture_of(const Texture& texture, int x, int width, int channels);

} // namespace gonio
#pragma GCC visibility pop
