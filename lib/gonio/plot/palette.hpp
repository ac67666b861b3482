// Colours of diagrams and of false-colour pictures.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/plot/drawing.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace gonio {

// The colour of the i-th curve. The colours are distinct with the common kinds of colour blindness too (Okabe and Ito,
// Color Universal Design, 2008, without its yellow, which is hard to see on paper). Repeats after seven.
Ink series_color(std::size_t index);

// A ramp of colours; with few exceptions from dark to light, so that equal steps look equal. The knots are uniformly
// spaced on [0, 1] as sRGB-encoded bytes; between knots the encoded channels are interpolated.
struct Palette {
    std::string_view name;
    std::string_view summary;
    std::span<const Ink> knots;
    bool rises = true; // from dark to light

    // Three sRGB-encoded channels, 1 = 255. Values outside [0, 1] get the colour of that end; NaN is dark.
    std::array<float, 3> at(double value) const;
    Ink ink_at(double value) const; // the same, rounded to bytes
};

// The first, viridis, is the default.
std::span<const Palette> palettes();

// For signed values, 0 in the middle: blue through grey to red (K. Moreland, "Diverging Color Maps for Scientific
// Visualization", 2009). Not one of palettes(), because its lightness rises and falls.
const Palette& diverging_palette();

// Fails (usage) on an unknown name and suggests the nearest.
Result<const Palette*> find_palette(std::string_view name);

} // namespace gonio
