// The specular luminance of an area light by numerical integration: the reference for fast methods.
#pragma once

#include <gonio/shading/kernels.hpp>
#include <gonio/shading/vec3.hpp>

#include <functional>

namespace gonio::measure {

// Luminance towards `view` per luminance of the light, of GGX with F = 1 (single scattering) at the origin: ∫ D V n·l
// over the visible part of the light, which is centred at `center`. `light` gives shape, sizes, axes (unit) and sides;
// its position is not used. α ≥ 1e-3. Adaptive: 12 × 12 cells of the light's solid angle by 7 × 7 Gauss–Legendre
// points, quartered until four quarters agree with the whole within 1e-6/12 of the sum or nine times. On the horizon,
// where the integrand has a kink, the error is about 1e-5. Inside the light the whole hemisphere is lit. Takes about a
// millisecond.
double specular_by_quadrature(const shading::LightConstants& light, shading::vec3<double> center,
                              shading::vec3<double> normal, shading::vec3<double> view, double alpha);

// The same of any lobe: its value [1/sr] for light from l, unit and above the surface.
using LobeValue = std::function<double(shading::vec3<double> l)>;
double specular_by_quadrature(const shading::LightConstants& light, shading::vec3<double> center,
                              shading::vec3<double> normal, shading::vec3<double> view, const LobeValue& lobe);

} // namespace gonio::measure
