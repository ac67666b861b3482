// The charts that artists use to judge a material: what real surfaces reflect.
#pragma once

#include <gonio/base/diagnostics.hpp>
#include <gonio/scene/material.hpp>

namespace gonio {

// Compares the luminance of colours with the charts of "The Art of Remember Me" (S. Lagarde and L. Harduin, 2013), in
// 8-bit sRGB: a dielectric's diffuse albedo 32 to 243, its specular (f0) 43 to 65, usually 59; a metal's specular 186
// to 255. A warning for each colour outside. A material with a metal mask between 0 and 1 is not judged.
Diagnostics check_charts(const Material& material);

} // namespace gonio
