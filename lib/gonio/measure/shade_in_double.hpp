// The formulas of shading/shade.hpp in double, with the constants that the shading kernels read: what kernels and
// tables are compared with. Compiled once.
#pragma once

#include <gonio/shading/brdf.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/shading/reflect.hpp>

namespace gonio::measure {

// Outgoing luminance [nt] of both parts by the light's specular method. The light has a size, or is a sun.
shading::Reflected<double> shade_parts_in_double(const shading::SurfacePoint<double>& point,
                                                 const shading::LightConstants& light,
                                                 const shading::MaterialConstants& material);

} // namespace gonio::measure
