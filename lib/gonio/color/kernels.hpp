// Colour temperatures of many lights at once, on the widest vector unit of the machine.
//
// float, structures of arrays; temperatures in kelvin, 800 K to 1e6 K, |Duv| ≤ 0.1. An element that is outside these
// ranges or NaN gets NaN in all results: nothing is clamped. Largest Δu'v' against the 1 nm sum 4e-7, luminance within
// 1e-6 of 1. Nothing fails, allocates or throws; calls may run on any thread. Cost: MEASURED.md.
#pragma once

#include <gonio/color/rgb_space.hpp>
#include <gonio/simd/dispatch.hpp>

#include <cstddef>

namespace gonio::color {

// A space in the form that the kernels use. Results are linear RGB of luminance 1, negative outside the gamut.
struct RgbConstants {
    float a[3] = {};
    float b[3] = {};
    float c[3] = {};
};
RgbConstants rgb_constants(const RgbSpace& space);

struct Kernels {
    simd::InstructionSet set;
    const char* name; // of the instruction set
    std::size_t lanes;

    // u', v' of black bodies.
    void (*planckian_uv_prime)(const float* temperature_k, std::size_t count, float* const uv_prime[2]);

    // RGB of black bodies.
    void (*planckian_rgb)(const float* temperature_k, std::size_t count, const RgbConstants& space,
                          float* const rgb[3]);

    // RGB of colours off the locus, by temperature and Duv.
    void (*cct_rgb)(const float* temperature_k, const float* duv, std::size_t count, const RgbConstants& space,
                    float* const rgb[3]);

    // RGB by Krystek's formula (1985), which is valid for 1000–15000 K (not checked): the baseline for the other
    // kernels.
    void (*krystek_rgb)(const float* temperature_k, std::size_t count, const RgbConstants& space, float* const rgb[3]);
};

// The kernels of `set`, or the scalar ones where simd::available(set) is false.
const Kernels& kernels(simd::InstructionSet set);

} // namespace gonio::color
