// A drawing as pixels.
//
// Areas cover a pixel by their exact share of it, lines by their share across (ends and joints are round); colours are
// mixed sRGB-encoded, as programs that show SVG do. Lines along the axes and text are moved by less than a pixel, so
// that they are sharp. Equal drawings give equal pixels. Nothing fails.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/plot/drawing.hpp>

namespace gonio {

// Draws into a picture of three display-encoded channels, 1 = white; the page's corner lies at `corner`. What lies
// outside of the picture is left out.
void draw(const Drawing& drawing, Image& image, PagePoint corner = {});

// The page, on white paper.
Image to_image(const Drawing& drawing);

// Copies a picture into another one of as many channels, its upper left pixel to (left, top); outside is left out.
void paste(const Image& from, Image& to, int left, int top);

} // namespace gonio
