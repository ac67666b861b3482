// A material as two reflectances that are integrated separately: its diffuse scattering, and its lobe.
#pragma once

#include <gonio/scene/material.hpp>
#include <gonio/shading/vec3.hpp>

#include <functional>

namespace gonio::detail {

struct SurfaceParts {
    // The BRDF [1/sr] of the channels for the normal, the direction to the light and the direction to the eye, all
    // unit.
    using Reflectance =
        std::function<shading::vec3<double>(shading::vec3<double> n, shading::vec3<double> l, shading::vec3<double> v)>;

    Reflectance diffuse;
    Reflectance specular;
    double alpha = 1.0; // of the specular lobe, as defined for GGX; 1 if there is none
};

SurfaceParts surface_parts(const Material& material);

} // namespace gonio::detail
