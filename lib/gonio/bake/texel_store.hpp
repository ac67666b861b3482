// What becomes of means when they are stored: the texels themselves, and what rounding and filtering take from them.
//
// The same bits on every instruction set (gonio/bake/kernels.hpp). No function here allocates or fails.
#pragma once

#include <gonio/bake/texture.hpp>

#include <cstddef>
#include <span>

namespace gonio {

// What stored texels add up to.
struct StoredTotals {
    double lumens = 0.0;             // of the texels as stored
    double steradians = 0.0;         // of all texels
    double max_error = 0.0;          // |texel as stored − web| at the texels' centres [cd]
    double quantization_error = 0.0; // |texel as stored − mean|, negative means as 0 [cd]
    double deepest_negative = 0.0;   // the least mean, where it is below 0 [cd]
    std::size_t evaluated = 0;       // texels whose mean was computed

    StoredTotals& operator+=(const StoredTotals& other);
};

// Texels whose means, and the web's values at their centres, lie on straight lines: that of the k-th is mean +
// k·mean_step.
struct LinearRun {
    double mean = 0.0; // [cd]
    double mean_step = 0.0;
    double center = 0.0; // [cd]
    double center_step = 0.0;
};

// How a texture stores.
struct Storage {
    TexelType type = TexelType::float32;
    double cd_per_unit = 1.0;
    Transfer transfer = Transfer::linear;
};

// Stores one texel and notes its errors; what is stored, in candela. Its flux is the caller's to add.
double store_texel(double mean, double center, const Storage& storage, float& texel, StoredTotals& totals);

// The same for a run of them, at least one, some 1 ns each; the sum of what is stored, in candela.
double store_run(const LinearRun& run, const Storage& storage, std::span<float> texels, StoredTotals& totals);

} // namespace gonio
