// A drawing as pixels.
//
// The coverage of a pixel is exact for areas; for lines it is measured across the line (ends and joints are round).
// Colours are mixed sRGB-encoded, as programs that show SVG do. Lines along the axes and text are moved by less than a
// pixel to make them sharp. Equal drawings give equal pixels. Nothing fails.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/plot/drawing.hpp>

namespace gonio {

// Draws into a picture of three display-encoded channels, 1 = white, with the page's corner at `corner`. Anything
// outside of the picture is clipped.
void draw(const Drawing& drawing, Image& image, PagePoint corner = {});

// The page, on white paper.
Image to_image(const Drawing& drawing);

// Copies a picture into another one with the same number of channels, with its upper left pixel at (left, top); pixels
// outside are clipped.
void paste(const Image& from, Image& to, int left, int top);

} // namespace gonio
