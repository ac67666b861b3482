// The figures of colour rendering of a light that is sampled already, with its colour temperature.
#pragma once

#include <gonio/color/color_fidelity.hpp>
#include <gonio/color/color_rendering.hpp>
#include <gonio/color/detail/test_light.hpp>

namespace gonio::detail {

ColorRendering rendering_of_rays(const Rays& light, Kelvin temperature);
ColorFidelity fidelity_of_rays(const Rays& light, Kelvin temperature);

} // namespace gonio::detail
