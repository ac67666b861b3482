// What the figures of colour rendering share: the light, its reference illuminant, and sums over samples lit by them.
//
// Everything is summed over 380–780 nm at the wavelengths of the light: those of its table in uniform steps of at most
// 5 nm, else interpolated, as in spectrum.hpp. The reference illuminant is computed at the same wavelengths, so that a
// light that is its own reference differs from it by nothing.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/color/cct.hpp>
#include <gonio/color/detail/quality_tables.hpp>
#include <gonio/color/reference_illuminant.hpp>
#include <gonio/color/spectrum.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gonio::detail {

// Power at wavelengths from 380 to 780 nm.
struct Rays {
    std::vector<double> nm; // ascending
    std::vector<double> power;
};

// The spectrum within 380–780 nm, over its maximum there, and 0 where its table ends before. Fails (usage) on a
// spectrum that is dark there.
Result<Rays> rays_of(const Spectrum& spectrum);

// Fails (usage) if there is no reference illuminant for the colour: no visible light, a colour without a temperature,
// or one outside 500–25000 K.
Result<Cct> reference_temperature(const Spectrum& spectrum);

// At the same wavelengths, any scale.
Rays reference_rays(const Rays& light, Kelvin temperature, ReferenceIlluminant kind);

enum class Observer { cie_1931, cie_1964 };

// X, Y, Z that the light gives to radiance factors at the wavelengths of the samples' tables: 380, 385, … 780 nm.
// Between them factors are interpolated by Sprague's formula, as CIE 224 does for lights in steps of 1 nm. Scaled to Y
// = 100 of the light itself.
using NodeWeights = std::array<glm::dvec3, sample_nodes>;
NodeWeights node_weights(const Rays& light, Observer by);

// XYZ of the light itself, the sum of its weights: Y is 100.
glm::dvec3 white_of(const NodeWeights& weights);

// XYZ of each sample.
template<std::size_t n, class T>
std::array<glm::dvec3, n> lit(const std::array<std::array<T, n>, sample_nodes>& samples, double unit,
                              const NodeWeights& weights) {
    std::array<double, n> x{};
    std::array<double, n> y{};
    std::array<double, n> z{};
    for (std::size_t node = 0; node < sample_nodes; ++node) {
        const glm::dvec3 weight = unit * weights[node];
        for (std::size_t i = 0; i < n; ++i) {
            const double factor = samples[node][i];
            x[i] += weight.x * factor;
            y[i] += weight.y * factor;
            z[i] += weight.z * factor;
        }
    }
    std::array<glm::dvec3, n> xyz;
    for (std::size_t i = 0; i < n; ++i)
        xyz[i] = {x[i], y[i], z[i]};
    return xyz;
}

} // namespace gonio::detail
