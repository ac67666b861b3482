// Webs shared by several tests.
#pragma once

#include <gonio/web/web.hpp>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace gonio::test {

inline std::vector<double> steps(double first, double last, std::size_t count) {
    std::vector<double> angles(count);
    for (std::size_t i = 0; i < count; ++i)
        angles[i] = first + (last - first) * static_cast<double>(i) / static_cast<double>(count - 1);
    return angles;
}

// Random candela from [0, 1000): without structure that could hide a wrong formula.
inline Web random_web(Symmetry stored, std::vector<double> planes, std::vector<double> gammas, unsigned seed) {
    std::mt19937 generator(seed);
    std::vector<double> candela(planes.size() * gammas.size());
    for (double& cd : candela)
        cd = 1000.0 * static_cast<double>(generator()) / 4294967296.0;
    return *Web::create(stored, std::move(planes), std::move(gammas), std::move(candela));
}

// Flux by the midpoint rule inside every cell of the full circle: slow, and independent of the closed form.
inline double flux_by_midpoints(const Web& web, int c_count, int per_cell) {
    constexpr double rad = std::numbers::pi / 180.0;
    double sum = 0.0;
    for (std::size_t j = 1; j < web.gammas_deg().size(); ++j) {
        const double low = web.gammas_deg()[j - 1];
        const double step = (web.gammas_deg()[j] - low) / per_cell;
        for (int k = 0; k < per_cell; ++k) {
            const double gamma = low + (k + 0.5) * step;
            double ring = 0.0;
            for (int i = 0; i < c_count; ++i)
                ring += web.candela((i + 0.5) * 360.0 / c_count, gamma);
            sum += ring * 2.0 * std::numbers::pi / c_count * std::sin(gamma * rad) * step * rad;
        }
    }
    return sum;
}

} // namespace gonio::test
