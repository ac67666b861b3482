// A drawing as SVG 1.1.
//
// Coordinates are written with at most two decimals: a hundredth of a pixel is below the resolution of any screen.
// Equal drawings give equal bytes. Text is escaped. Nothing fails.
#pragma once

#include <gonio/plot/drawing.hpp>

#include <string>

namespace gonio {

// The whole document, on a white background.
std::string to_svg(const Drawing& drawing);

// At most two decimals, no exponent, no negative zero.
std::string svg_number(double value);

} // namespace gonio
