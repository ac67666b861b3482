#include <gonio/base/gauss_legendre.hpp>
#include <gonio/measure/sphere_truth.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace gonio::measure {

namespace {

using Real = long double;
constexpr Real pi = std::numbers::pi_v<Real>;

template<class Integrand>
Real gauss(Real low, Real high, const Integrand& f) {
    constexpr auto rule = gauss_legendre<16, Real>();
    Real sum = 0;
    for (const auto& node : rule)
        sum += node.weight * f(low + (high - low) * (1 + node.at) / 2);
    return sum * (high - low) / 2;
}

// The ring at angle α from the axis, where the horizon cuts it: ∫ 2b (cosφ − cosφ0) dφ over 0 … φ0, b = sinθ sinα.
// The two cosines of α±θ determine φ0 and are passed in, so that they can be exact where they vanish.
Real cut_ring(Real b, Real cos_difference, Real minus_cos_sum) {
    const Real phi0 =
        2 * std::atan2(std::sqrt(std::fmax(cos_difference, Real(0))), std::sqrt(std::fmax(minus_cos_sum, Real(0))));
    return 4 * b * gauss(0, phi0, [&](Real phi) { return std::sin((phi0 + phi) / 2) * std::sin((phi0 - phi) / 2); });
}

} // namespace

double sphere_irradiance_by_quadrature(const double (&center)[3], double radius, const double (&normal)[3]) {
    const Real c[3] = {center[0], center[1], center[2]};
    const Real n[3] = {normal[0], normal[1], normal[2]};
    const Real r = radius;
    const Real cross[3] = {n[1] * c[2] - n[2] * c[1], n[2] * c[0] - n[0] * c[2], n[0] * c[1] - n[1] * c[0]};
    const Real theta = std::atan2(std::sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]),
                                  n[0] * c[0] + n[1] * c[1] + n[2] * c[2]);
    const Real sigma = std::atan2(r, std::sqrt((c[0] * c[0] - r * r) + c[1] * c[1] + c[2] * c[2]));

    // Rings that are wholly visible, below the angle at which the horizon begins to cut them.
    const Real first_cut = pi / 2 - theta;
    Real total = 0;
    const Real whole = std::fmin(first_cut, sigma);
    if (whole > 0)
        total +=
            gauss(0, whole, [&](Real alpha) { return 2 * pi * std::cos(theta) * std::cos(alpha) * std::sin(alpha); });

    // Rings that are cut: α = |π/2 − θ| + u.
    const Real start = std::fabs(first_cut);
    const Real width = sigma - start;
    if (width <= 0) return static_cast<double>(total);
    const Real sin_theta = std::sin(theta);
    const auto ring = [&](Real u) {
        const Real alpha = start + u;
        // cos(θ−α) and −cos(θ+α); the one that vanishes at u = 0 is sin u, exactly.
        const Real cos_difference = first_cut < 0 ? std::sin(u) : std::cos(theta - alpha);
        const Real minus_cos_sum = first_cut < 0 ? -std::cos(theta + alpha) : std::sin(u);
        return std::sin(alpha) * cut_ring(sin_theta * std::sin(alpha), cos_difference, minus_cos_sum);
    };
    // u = width/(1 + exp(−2 g)), g = π/2 sinh t: this smooths away the square-root behaviour at u = 0.
    constexpr Real step = 1 / 16.0L;
    Real sum = 0;
    for (int k = -72; k <= 72; ++k) {
        const Real t = step * static_cast<Real>(k);
        const Real g = pi / 2 * std::sinh(t);
        const Real u = width / (1 + std::exp(-2 * g));
        const Real cosh_g = std::cosh(g);
        sum += ring(u) * (pi / 4) * std::cosh(t) / (cosh_g * cosh_g);
    }
    return static_cast<double>(total + width * step * sum);
}

} // namespace gonio::measure
