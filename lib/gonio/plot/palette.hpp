// Colours of diagrams and of false-colour pictures.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/plot/drawing.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace gonio {

// Of the i-th curve; told apart with the common kinds of colour blindness too (Okabe and Ito, Color Universal Design,
// 2008, without its yellow, which paper swallows). Repeats after seven.
Ink series_color(std::size_t index);

// A ramp from dark to light along which even steps look even. The knots stand evenly on [0, 1], sRGB-encoded bytes;
// between two of them the encoded channels are mixed.
struct Palette {
    std::string_view name;
    std::string_view summary;
    std::span<const Ink> knots;

    // Three sRGB-encoded channels, 1 = 255. Values outside [0, 1] take the end's colour, NaN is dark.
    std::array<float, 3> at(double value) const;
    Ink ink_at(double value) const; // the same, rounded to bytes
};

// viridis first, which is the default.
std::span<const Palette> palettes();

// For signed values, 0 in the middle: blue over grey to red (K. Moreland, "Diverging Color Maps for Scientific
// Visualization", 2009). Not one of palettes(): its lightness rises and falls.
const Palette& diverging_palette();

// Fails (usage) on an unknown name, naming the nearest.
Result<const Palette*> find_palette(std::string_view name);

} // namespace gonio
