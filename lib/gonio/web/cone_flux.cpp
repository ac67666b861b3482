#include <gonio/base/gauss_legendre.hpp>
#include <gonio/web/cone_flux.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr double radians_per_degree = pi / 180.0;

constexpr auto rule = gauss_legendre<6>();
constexpr double widest = 0.2; // in ψ, of a piece for one quadrature rule

} // namespace

ConeFlux::ConeFlux(const Web& web) : meridians_(web), axis_sideways_(web.photometry() == Photometry::a) {}

ConeFlux::Halves ConeFlux::cone(double half_angle_rad, bool about_zenith) const {
    const double gamma = half_angle_rad;
    if (!(gamma > 0.0)) return {};
    const double cos_gamma = gamma < 0.5 * pi ? std::cos(gamma) : 0.0;
    const auto azimuth_of = [&](double t) { return about_zenith ? pi - t : t; };

    // Cuts of ψ, with t = γ cosψ counted from the cone's axis: where the outline meets the grid, where front and back
    // are separated, and around both ends, where the outline of a wide cone turns over an interval as short as its
    // distance to the poles.
    std::vector<double> cuts{0.0, 0.5 * pi, pi};
    const auto cut_at = [&](double t) {
        if (std::abs(t) < gamma) cuts.push_back(std::acos(t / gamma));
    };
    for (const double azimuth : meridians_.azimuth_breaks())
        cut_at(std::remainder(about_zenith ? pi - azimuth : azimuth, 2.0 * pi));
    for (const double cosine : meridians_.polar_break_cosines()) {
        const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
        if (!(sine > cos_gamma)) continue;
        const double t = std::acos(cos_gamma / sine);
        cut_at(t);
        cut_at(-t);
    }
    // NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter): doubling is exact
    for (double near = std::sqrt(0.5 * std::max(cos_gamma, 1e-12)); near < 0.25 * pi; near *= 2.0) {
        cuts.push_back(near);
        cuts.push_back(pi - near);
    }
    std::sort(cuts.begin(), cuts.end());

    Halves lumens;
    const auto add_piece = [&](double from, double to) {
        const double middle = 0.5 * (from + to);
        const double half = 0.5 * (to - from);
        const double t_middle = gamma * std::cos(middle);
        const std::size_t sector = meridians_.sector_of(azimuth_of(t_middle));
        const double theta_middle = std::asin(std::min(cos_gamma / std::cos(t_middle), 1.0));
        const std::size_t near_cell = meridians_.cell_of(theta_middle);
        const std::size_t far_cell = meridians_.cell_of(pi - theta_middle);
        const std::size_t equator_cell = meridians_.cell_of(0.5 * pi);
        const auto add = [&](double psi, double weight) {
            const double t = gamma * std::cos(psi);
            const double cos_t = std::cos(t);
            const double sine = std::min(cos_gamma / cos_t, 1.0);
            // 1 − sin²θ without cancellation at the ends.
            const double cosine = std::sqrt(std::max(std::sin(gamma - t) * std::sin(gamma + t), 0.0)) / cos_t;
            const double theta = std::atan2(sine, cosine);
            const double azimuth = azimuth_of(t);
            const double d_t = weight * gamma * std::sin(psi);
            const double near = meridians_.integral(sector, azimuth, near_cell, theta, cosine, sine).to_here;
            const double far = meridians_.integral(sector, azimuth, far_cell, pi - theta, -cosine, sine).to_here;
            if (axis_sideways_) {
                (t > 0.0 ? lumens.front : lumens.back) += d_t * (far - near);
            } else {
                const double equator = meridians_.integral(sector, azimuth, equator_cell, 0.5 * pi, 0.0, 1.0).to_here;
                lumens.front += d_t * (far - equator);
                lumens.back += d_t * (equator - near);
            }
        };
        for (const QuadratureNode& node : rule)
            add(middle + half * node.at, half * node.weight);
    };
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        const double width = cuts[i] - cuts[i - 1];
        if (!(width > 0.0)) continue;
        const int pieces = static_cast<int>(std::ceil(width / widest));
        for (int k = 0; k < pieces; ++k)
            add_piece(cuts[i - 1] + width * k / pieces, cuts[i - 1] + width * (k + 1) / pieces);
    }
    return lumens;
}

ConeFlux::Halves ConeFlux::zone(double gamma_low_deg, double gamma_high_deg) const {
    const auto below = [&](double gamma_deg) { return cone(gamma_deg * radians_per_degree, false); };
    const auto above = [&](double gamma_deg) { return cone((180.0 - gamma_deg) * radians_per_degree, true); };
    Halves lumens;
    if (gamma_low_deg < 90.0) lumens = below(std::min(gamma_high_deg, 90.0)) - below(gamma_low_deg);
    if (gamma_high_deg > 90.0) lumens = lumens + (above(std::max(gamma_low_deg, 90.0)) - above(gamma_high_deg));
    return lumens;
}

} // namespace gonio
