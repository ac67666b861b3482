#include <gonio/web/integrate.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace gonio {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180.0;

// ∫ of w sinγ for w linear from γ_low to γ_high, with what depends on the angles alone: each plane of a web has the
// same. With m the middle, h the half width, w̄ the mean and δ half the rise:
//   ∫ = 2[ w̄ sin m sin h + δ cos m (sin h/h − cos h) ],
// with a series for the parentheses at small h, where they cancel; at h = ½ the next term is 1e-17 of them.
class SineCell {
public:
    SineCell(double gamma_low, double gamma_high) {
        const double m = 0.5 * (gamma_low + gamma_high);
        const double h = 0.5 * (gamma_high - gamma_low);
        const double h2 = h * h;
        const double series =
            1.0 -
            h2 / 10.0 *
                (1.0 - h2 / 28.0 * (1.0 - h2 / 54.0 * (1.0 - h2 / 88.0 * (1.0 - h2 / 130.0 * (1.0 - h2 / 180.0)))));
        sin_middle_ = std::sin(m);
        cos_middle_ = std::cos(m);
        sin_half_ = std::sin(h);
        bracket_ = h < 0.5 ? h2 / 3.0 * series : sin_half_ / h - std::cos(h);
    }

    [[nodiscard]] double integral(double w_low, double w_high) const {
        const double mean = 0.5 * (w_low + w_high);
        const double half_rise = 0.5 * (w_high - w_low);
        return 2.0 * (mean * sin_middle_ * sin_half_ + half_rise * cos_middle_ * bracket_);
    }

private:
    double sin_middle_;
    double cos_middle_;
    double sin_half_;
    double bracket_;
};

// make(γ_low, γ_high) of each step.
template<class Make>
auto sine_cells(std::span<const double> gammas_deg, Make&& make) {
    std::vector<decltype(make(0.0, 0.0))> cells;
    cells.reserve(gammas_deg.size());
    for (std::size_t j = 1; j < gammas_deg.size(); ++j)
        cells.push_back(make(gammas_deg[j - 1], gammas_deg[j]));
    return cells;
}

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
    return SineCell(gamma_low, gamma_high).integral(w_low, w_high);
}

Lumens flux(const Web& web) {
    if (web.photometry() != Photometry::c) return over_latitudes(web, integrate_linear_cos);
    const std::vector<SineCell> cells = sine_cells(web.gammas_deg(), [](double low_deg, double high_deg) {
        return SineCell(low_deg * radians_per_degree, high_deg * radians_per_degree);
    });
    return over_planes(web, [&](std::span<const double> column) {
        double sum = 0.0;
        for (std::size_t j = 0; j < cells.size(); ++j)
            sum += cells[j].integral(column[j], column[j + 1]);
        return sum;
    });
}

Lumens zonal_flux(const Web& web) {
    if (web.photometry() != Photometry::c) return over_latitudes(web, mean_cos);
    // cosγ₁ − cosγ₂ = 2 sin m sin h
    struct Zone {
        double sin_middle;
        double sin_half;
    };
    const std::vector<Zone> zones = sine_cells(web.gammas_deg(), [](double low_deg, double high_deg) {
        return Zone{std::sin(0.5 * (low_deg + high_deg) * radians_per_degree),
                    std::sin(0.5 * (high_deg - low_deg) * radians_per_degree)};
    });
    return over_planes(web, [&](std::span<const double> column) {
        double sum = 0.0;
        for (std::size_t j = 0; j < zones.size(); ++j)
            sum += 0.5 * (column[j] + column[j + 1]) * 2.0 * zones[j].sin_middle * zones[j].sin_half;
        return sum;
    });
}

} // namespace gonio
