// The colour vector graphic of ANSI/IES TM-30: how a light shifts hue and chroma around the circle of hues.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/color/light_quality.hpp>
#include <gonio/plot/drawing.hpp>

#include <string>

#pragma GCC visibility push(default)
namespace gonio {

// How large the graphic is, and what stands above it.
struct ColorVectorOptions {
    int width_px = 720;
    int height_px = 720;
    std::string title; // UTF-8
};

// The black circle is the reference illuminant, the red curve the light, joined through the means of the 16 hue bins;
// arrows lead from one to the other. An arrow outwards is more chroma, one along the circle another hue; thin circles
// are 10 and 20 % of chroma. Rf, Rg, the colour temperature and Duv are in the corners. Fails (usage) on a light
// without a reference illuminant, and on a page of fewer than 160 pixels or more than 16384.
Result<Drawing> color_vector_graphic(const LightQuality& quality, const ColorVectorOptions& options = {});

} // namespace gonio
#pragma GCC visibility pop
