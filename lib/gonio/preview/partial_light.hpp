// Pixels that show a light in a part of them, for displays.
//
// In linear light such a pixel is their mean, which is what an instrument measures and what pictures of numbers store.
// On a display it is as white as the light itself, since both are beyond what the display shows, and the outline looks
// like stairs. So the parts go through the display's curve separately, and their mean is taken behind it.
//
// A light narrower than a pixel would vanish that way: white on a hundredth of the pixel. It is drawn as a pixel wide
// as far as its light suffices, and never brighter than the mean.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/quantity.hpp>

#include <array>
#include <cstdint>
#include <span>

#pragma GCC visibility push(default)
namespace gonio {

// A pixel has one for each light that it shows in part.
struct PartialLight {
    std::uint32_t pixel = 0;    // row by row
    float share = 0.0F;         // of the pixel, in (0, 1)
    std::array<float, 3> rgb{}; // of the light, in the unit of the picture
    float widening = 1.0F;      // ≥ 1: how many times its share a light beyond white may take on a display
};

// As the pixels of the picture: expose() in exposure.hpp.
void expose(std::span<PartialLight> lights, Ev100 ev);

// For each pixel that shows lights in part, what remains of it without them, then these lights: one after the other in
// a row. `lights` are in the order of their pixels.
Image parts_of(const Image& picture, std::span<const PartialLight> lights);

// Replaces those pixels of the display-encoded `picture` by the mean of their `parts`, which went through the same
// curve in the order of parts_of(): the mean of what the display shows of each, in linear sRGB.
void merge_parts(const Image& parts, std::span<const PartialLight> lights, Image& picture);

} // namespace gonio
#pragma GCC visibility pop
