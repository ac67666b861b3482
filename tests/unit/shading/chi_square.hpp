// Pearson's χ² test of a sampler of directions against its stated density.
//
// The sphere is divided about an axis: rings at the angles θ = π s x/(1 − x + s x), x uniform in [0, 1], which crowd
// about the axis for small s, and sectors. A sampler's density is integrated over each cell by quadrature, so the test
// checks both that directions fall where the density says and that the density integrates to 1.
#pragma once

#include "poses.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace chi_square {

using poses::Vec;

// Q(a, x), the upper regularised incomplete gamma function: its series below a + 1, its continued fraction (W. Lentz)
// above. a > 0, x ≥ 0.
inline double upper_gamma(double a, double x) {
    if (!(x > 0.0)) return 1.0;
    const double scale = std::exp(a * std::log(x) - x - std::lgamma(a));
    if (x < a + 1.0) {
        double term = 1.0 / a;
        double sum = term;
        for (int k = 1; k < 10'000 && term > sum * 1e-16; ++k)
            sum += term *= x / (a + k);
        return 1.0 - scale * sum;
    }
    double b = x + 1.0 - a;
    double c = 1e300;
    double d = 1.0 / b;
    double fraction = d;
    for (int k = 1; k < 10'000; ++k) {
        const double numerator = k * (a - k);
        b += 2.0;
        d = 1.0 / (numerator * d + b);
        c = b + numerator / c;
        const double step = c * d;
        fraction *= step;
        if (std::fabs(step - 1.0) < 1e-15) break;
    }
    return scale * fraction;
}

// The least probability that one of `tests` may have if all of them together have a false alarm rate of `total` (Z.
// Šidák, 1967).
inline double sidak(double total, std::size_t tests) {
    return -std::expm1(std::log1p(-total) / static_cast<double>(tests));
}

class Cells {
public:
    static constexpr std::size_t rings = 24;
    static constexpr std::size_t sectors = 32;

    // `axis` and `across` need not be perpendicular or unit vectors; `narrow` is s, in (0, 1].
    Cells(Vec axis, Vec across, double narrow) : z_(poses::unit(axis)), narrow_(narrow) {
        y_ = gonio::shading::cross(z_, across);
        if (gonio::shading::dot(y_, y_) < 1e-12)
            y_ = gonio::shading::cross(z_, std::fabs(z_.x) < 0.5 ? Vec{1, 0, 0} : Vec{0, 1, 0});
        y_ = poses::unit(y_);
        x_ = gonio::shading::cross(y_, z_);
    }

    [[nodiscard]] std::size_t index(Vec l) const {
        const double x = gonio::shading::dot(l, x_);
        const double y = gonio::shading::dot(l, y_);
        const double theta = std::atan2(std::hypot(x, y), gonio::shading::dot(l, z_));
        const double t = theta / std::numbers::pi;
        const double ring = t / (narrow_ * (1.0 - t) + t);
        const double sector = std::atan2(y, x) / (2.0 * std::numbers::pi) + 0.5;
        const auto at = [](double part, std::size_t count) {
            return std::min(static_cast<std::size_t>(part * static_cast<double>(count)), count - 1);
        };
        return at(ring, rings) * sectors + at(sector, sectors);
    }

    // The integral of `density` over each cell, by `points`² midpoints.
    template<class Density>
    [[nodiscard]] std::vector<double> integrals(const Density& density, std::size_t points) const {
        std::vector<double> result(rings * sectors);
        const double step = 1.0 / static_cast<double>(rings * points);
        const double turn = 2.0 * std::numbers::pi / static_cast<double>(sectors * points);
        for (std::size_t i = 0; i < rings * points; ++i) {
            const double x = (static_cast<double>(i) + 0.5) * step;
            const double below = 1.0 - x + narrow_ * x;
            const double theta = std::numbers::pi * narrow_ * x / below;
            const double sine = std::sin(theta);
            const double measure = sine * std::numbers::pi * narrow_ / (below * below) * step * turn;
            for (std::size_t k = 0; k < sectors * points; ++k) {
                const double phi = (static_cast<double>(k) + 0.5) * turn - std::numbers::pi;
                const Vec l = x_ * (sine * std::cos(phi)) + y_ * (sine * std::sin(phi)) + z_ * std::cos(theta);
                result[i / points * sectors + k / points] += density(l) * measure;
            }
        }
        return result;
    }

private:
    Vec x_, y_, z_;
    double narrow_;
};

struct Outcome {
    double integral = 0.0;    // of the density over the sphere
    double statistic = 0.0;   // χ²
    std::size_t degrees = 0;  // of freedom
    double probability = 0.0; // of a χ² at least this large, if the density is right
};

// `sample()` gives a unit Vec, `count` times. Cells that expect fewer than 5 are pooled.
template<class Sample, class Density>
Outcome test(const Cells& cells, const Sample& sample, const Density& density, std::size_t count,
             std::size_t points = 8) {
    std::vector<double> expected = cells.integrals(density, points);
    std::vector<double> found(expected.size());
    for (std::size_t i = 0; i < count; ++i)
        found[cells.index(sample())] += 1.0;
    Outcome outcome;
    double pooled_expected = 0.0;
    double pooled_found = 0.0;
    const auto add = [&](double e, double f) {
        outcome.statistic += (f - e) * (f - e) / e;
        ++outcome.degrees;
    };
    for (std::size_t i = 0; i < expected.size(); ++i) {
        outcome.integral += expected[i];
        const double e = expected[i] * static_cast<double>(count);
        if (e >= 5.0) {
            add(e, found[i]);
            continue;
        }
        pooled_expected += e;
        pooled_found += found[i];
        if (pooled_expected >= 5.0) {
            add(pooled_expected, pooled_found);
            pooled_expected = pooled_found = 0.0;
        }
    }
    // The remainder is too little for a separate cell.
    if (pooled_expected > 0.0) add(std::max(pooled_expected, 1.0), pooled_found);
    if (outcome.degrees > 1) --outcome.degrees;
    outcome.probability = upper_gamma(0.5 * static_cast<double>(outcome.degrees), 0.5 * outcome.statistic);
    return outcome;
}

} // namespace chi_square
