// The specular luminance of an area light at many surface points, by any named method, with the widest instruction set
// available.
//
// As kernels.hpp: floats in structures of arrays, metres, unit directions; the functions do not fail, allocate or
// throw, and results are finite and not negative for any finite input.
#pragma once

#include <gonio/shading/kernels.hpp>
#include <gonio/shading/specular_method.hpp>
#include <gonio/simd/dispatch.hpp>

#include <cstddef>

namespace gonio::shading {

// GGX with α_x along the tangent of each surface point and α_y across it (anisotropic_lobe.hpp).
struct AnisotropicLobeConstants {
    float alpha[2] = {0.3F, 0.3F}; // x and y; less than minimum_alpha counts as that
    float across[3] = {0.0F, 0.0F, 1.0F};
    float cosine = 1.0F, sine = 0.0F;
};

struct SpecularKernels {
    simd::InstructionSet set;
    const char* name; // of the instruction set
    std::size_t lanes;

    // GGX of α under `light`, per luminance of the light, one per surface point: scale is for F = 1, and Schlick's
    // reflectance gives scale·(f0 + (f90 − f0)·grazing). 0 and 0 for a punctual light. The window is not applied.
    void (*specular)(const Surfaces&, const LightConstants& light, float alpha, SpecularMethod, float* scale,
                     float* grazing);

    // The same for a power of n·h, ≥ 2 (brdf_blinn.hpp).
    void (*specular_power)(const Surfaces&, const LightConstants& light, float power, SpecularMethod, float* scale,
                           float* grazing);

    // The same for an anisotropic lobe.
    void (*specular_anisotropic)(const Surfaces&, const LightConstants& light, const AnisotropicLobeConstants& lobe,
                                 SpecularMethod, float* scale, float* grazing);
};

// The kernels of `set`, or the scalar ones where simd::available(set) is false.
const SpecularKernels& specular_kernels(simd::InstructionSet set);

} // namespace gonio::shading
