// A Lambertian web, fine enough to be taken for the cosine.
#pragma once

#include <gonio/web/web.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace gonio::test {

// I = (Φ/π) cosγ below the horizon, linear between steps of `step_deg`.
inline Web lambertian_web(double flux_lm, double step_deg = 0.125, bool upward = false) {
    std::vector<double> gammas;
    std::vector<double> candela;
    const int count = static_cast<int>(90.0 / step_deg);
    for (int i = 0; i <= count; ++i) {
        const double from_axis_deg = upward ? 90.0 - i * step_deg : i * step_deg;
        gammas.push_back(upward ? 180.0 - from_axis_deg : from_axis_deg);
        candela.push_back(i == (upward ? 0 : count)
                              ? 0.0
                              : flux_lm / std::numbers::pi * std::cos(from_axis_deg * std::numbers::pi / 180.0));
    }
    return *Web::create(Symmetry::axial, {0.0}, gammas, candela);
}

} // namespace gonio::test
