// Lines of equal light over a picture, with their numbers.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/plot/drawing.hpp>
#include <gonio/plot/palette.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace gonio {

// Round multiples of `unit` between the least value of a picture and its greatest, over at most three decades: 1, 2 and
// 5 times the powers of ten, or finer steps where those are fewer than six.
std::vector<double> contour_levels(double least, double greatest, double unit);

// A colour for each of `count` levels, from the brighter part of the palette, which stands out from a dimmed picture.
std::vector<Ink> contour_inks(std::size_t count, const Palette& palette);

// Dims towards black, so that lines stand out.
void dim(Image& picture);

// The lines of `values` (one channel) at `levels` (ascending, in the unit of the values), each in its ink, with the
// level in multiples of `unit` written on the line where there is room. `surfaces` comes from seen_surfaces: no line
// crosses from one surface to another.
Drawing contour_drawing(const Image& values, std::span<const std::int32_t> surfaces, std::span<const double> levels,
                        std::span<const Ink> inks, double unit);

} // namespace gonio
