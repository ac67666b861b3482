#include <gonio/web/integrate.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace gonio {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180.0;

// ∫ of w cosφ over the latitudes [low, high], computed with the sine of the colatitude.
double integrate_linear_cos(double low, double high, double w_low, double w_high) {
    constexpr double quarter = 0.5 * std::numbers::pi;
    return integrate_linear_sin(low + quarter, high + quarter, w_low, w_high);
}

// The industry's rule in place of the exact integral: the mean of the ends.
double mean_cos(double low, double high, double w_low, double w_high) {
    const double mean = 0.5 * (w_low + w_high);
    return integrate_linear_cos(low, high, mean, mean);
}

// The weight of each stored intensity in an integral over one axis: ∫ of its hat function by `cell`, which integrates a
// linear function over an interval.
template<class Cell>
std::vector<double> hat_integrals(std::span<const double> angles_deg, Cell&& cell) {
    std::vector<double> weights(angles_deg.size(), 0.0);
    for (std::size_t i = 1; i < angles_deg.size(); ++i) {
        const double low = angles_deg[i - 1] * radians_per_degree;
        const double high = angles_deg[i] * radians_per_degree;
        weights[i - 1] += cell(low, high, 1.0, 0.0);
        weights[i] += cell(low, high, 0.0, 1.0);
    }
    return weights;
}

// Types A and B: latitudes with `latitude_cell`, longitudes by the trapezoid rule, which is exact for linear functions.
template<class LatitudeCell>
Lumens over_latitudes(const Web& web, LatitudeCell&& latitude_cell) {
    const auto longitude_cell = [](double low, double high, double w_low, double w_high) {
        return 0.5 * (w_low + w_high) * (high - low);
    };
    const bool latitude_is_vertical = web.photometry() == Photometry::a;
    const std::vector<double> across = latitude_is_vertical ? hat_integrals(web.horizontal_deg(), longitude_cell)
                                                            : hat_integrals(web.horizontal_deg(), latitude_cell);
    const std::vector<double> along = latitude_is_vertical ? hat_integrals(web.vertical_deg(), latitude_cell)
                                                           : hat_integrals(web.vertical_deg(), longitude_cell);
    double sum = 0.0;
    for (std::size_t i = 0; i < across.size(); ++i) {
        const std::span<const double> column = web.column(i);
        double column_sum = 0.0;
        for (std::size_t j = 0; j < along.size(); ++j)
            column_sum += along[j] * column[j];
        sum += across[i] * column_sum;
    }
    return Lumens(sum * image_count(web.stored_symmetry()));
}

// Sums plane integrals over C: each is linear in C between planes, so the trapezoid rule is exact.
template<class PlaneIntegral>
Lumens over_planes(const Web& web, PlaneIntegral&& plane_integral) {
    const std::span<const double> planes = web.planes_deg();
    if (web.stored_symmetry() == Symmetry::axial) return Lumens(2.0 * std::numbers::pi * plane_integral(web.column(0)));
    double sum = 0.0;
    double before = plane_integral(web.column(0));
    for (std::size_t i = 1; i < planes.size(); ++i) {
        const double here = plane_integral(web.column(i));
        sum += 0.5 * (before + here) * (planes[i] - planes[i - 1]) * radians_per_degree;
        before = here;
    }
    return Lumens(sum * image_count(web.stored_symmetry()));
}

} // namespace

double integrate_linear_sin(double gamma_low, double gamma_high, double w_low, double w_high) {
    // With m the middle, h the half width, w̄ the mean and δ half the rise:
    //   ∫ = 2[ w̄ sin m sin h + δ cos m (sin h/h − cos h) ],
    // with a series for the parentheses at small h, where they cancel; at h = ½ the next term is 1e-17 of them.
    const double m = 0.5 * (gamma_low + gamma_high);
    const double h = 0.5 * (gamma_high - gamma_low);
    const double h2 = h * h;
    const double series =
        1.0 -
        h2 / 10.0 * (1.0 - h2 / 28.0 * (1.0 - h2 / 54.0 * (1.0 - h2 / 88.0 * (1.0 - h2 / 130.0 * (1.0 - h2 / 180.0)))));
    const double bracket = h < 0.5 ? h2 / 3.0 * series : std::sin(h) / h - std::cos(h);
    const double mean = 0.5 * (w_low + w_high);
    const double half_rise = 0.5 * (w_high - w_low);
    return 2.0 * (mean * std::sin(m) * std::sin(h) + half_rise * std::cos(m) * bracket);
}

Lumens flux(const Web& web) {
    if (web.photometry() != Photometry::c) return over_latitudes(web, integrate_linear_cos);
    const std::span<const double> gammas = web.gammas_deg();
    return over_planes(web, [&](std::span<const double> column) {
        double sum = 0.0;
        for (std::size_t j = 1; j < gammas.size(); ++j)
            sum += integrate_linear_sin(gammas[j - 1] * radians_per_degree, gammas[j] * radians_per_degree,
                                        column[j - 1], column[j]);
        return sum;
    });
}

Lumens zonal_flux(const Web& web) {
    if (web.photometry() != Photometry::c) return over_latitudes(web, mean_cos);
    const std::span<const double> gammas = web.gammas_deg();
    return over_planes(web, [&](std::span<const double> column) {
        double sum = 0.0;
        for (std::size_t j = 1; j < gammas.size(); ++j) {
            // cosγ₁ − cosγ₂ = 2 sin m sin h
            const double m = 0.5 * (gammas[j - 1] + gammas[j]) * radians_per_degree;
            const double h = 0.5 * (gammas[j] - gammas[j - 1]) * radians_per_degree;
            sum += 0.5 * (column[j - 1] + column[j]) * 2.0 * std::sin(m) * std::sin(h);
        }
        return sum;
    });
}

} // namespace gonio
