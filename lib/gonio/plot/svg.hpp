// A drawing as SVG 1.1.
//
// Coordinates are written with at most two decimals: a hundredth of a pixel is below the resolution of any screen.
// Equal drawings give equal bytes. Text is escaped. Nothing fails.
#pragma once

#include <gonio/plot/drawing.hpp>

#include <string>
#include <string_view>

namespace gonio {

// How a drawing is written.
struct SvgOptions {
    // Begins every identifier: several drawings in one HTML file need different ones.
    std::string_view id_prefix = {};
    // Paths in steps of a tenth of a pixel, areas by their outlines: a tenth of the bytes of a heat map.
    bool short_paths = false;
    // Of the width and height that the document states: "pt" for a page of paper.
    std::string_view unit = {};
};

// The whole document, on a white background.
std::string to_svg(const Drawing& drawing, const SvgOptions& options = {});

// At most two decimals, no exponent, no negative zero.
std::string svg_number(double value);

} // namespace gonio
