// The reflectance of a material for many pairs of directions, with the widest instruction set available.
//
// As kernels.hpp: floats in structures of arrays; the functions do not fail, allocate or throw, and results are finite
// and not negative for unit directions. The frame is that of the surface: its normal is +z. Both directions point away
// from it.
#pragma once

#include <gonio/shading/kernels.hpp>
#include <gonio/simd/dispatch.hpp>

#include <cstddef>

namespace gonio::shading {

// `count` can be any number; arrays need no alignment.
struct DirectionPairs {
    const float* to_light[3] = {}; // unit
    const float* to_eye[3] = {};   // unit
    std::size_t count = 0;
};

struct ReflectanceKernels {
    simd::InstructionSet set;
    const char* name; // of the instruction set
    std::size_t lanes;

    // Whether the squares of the lengths of all vectors are within 1e-5 of 1: what all kernels here expect. NaN is not.
    bool (*are_unit)(const float* const vectors[3], std::size_t count);

    // brdf() of brdf_sample.hpp [1/sr], with the coat if there is one; `rgb` is overwritten and must not overlap the
    // input. 0 where a direction is below the surface.
    void (*brdf)(const DirectionPairs&, const MaterialConstants&, float* const rgb[3]);
};

// The kernels of `set`, or the scalar ones where simd::available(set) is false.
const ReflectanceKernels& reflectance_kernels(simd::InstructionSet set);

} // namespace gonio::shading
