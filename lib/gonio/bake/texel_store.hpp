// Storing means: the texels themselves, and the errors that rounding and filtering cause.
//
// The same bits on every instruction set (gonio/bake/kernels.hpp). No function here allocates or fails.
#pragma once

#include <gonio/bake/texture.hpp>

#include <cstddef>
#include <span>

namespace gonio {

// Totals of stored texels.
struct StoredTotals {
    double lumens = 0.0;             // of the texels as stored
    double steradians = 0.0;         // of all texels
    double max_error = 0.0;          // |texel as stored − web| at the texels' centres [cd]
    double quantization_error = 0.0; // |texel as stored − mean|, negative means as 0 [cd]
    double deepest_negative = 0.0;   // the least mean, if it is below 0 [cd]
    std::size_t evaluated = 0;       // texels whose mean was computed

    StoredTotals& operator+=(const StoredTotals& other);
};

// Texels with means, and values of the web at their centres, on straight lines: texel k has the mean
// mean + k·mean_step.
struct LinearRun {
    double mean = 0.0; // [cd]
    double mean_step = 0.0;
    double center = 0.0; // [cd]
    double center_step = 0.0;
};

// How a texture stores values.
struct Storage {
    TexelType type = TexelType::float32;
    double cd_per_unit = 1.0;
    Transfer transfer = Transfer::linear;
};

// Stores one texel and records its errors; returns the stored value in candela. The caller adds its flux.
double store_texel(double mean, double center, const Storage& storage, float& texel, StoredTotals& totals);

// The same for a run of at least one texel, some 1 ns each; returns the sum of the stored values in candela.
double store_run(const LinearRun& run, const Storage& storage, std::span<float> texels, StoredTotals& totals);

} // namespace gonio
