// Lights and materials as the constants that the shading kernels read.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/shading/kernels.hpp>

namespace gonio {

// intensity_cd of a punctual light is left to the caller, because it differs for each surface point.
shading::LightConstants light_constants(const Light& light);

shading::MaterialConstants material_constants(const Material& material);

} // namespace gonio
