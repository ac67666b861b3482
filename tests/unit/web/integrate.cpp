#include <gonio/web/integrate.hpp>

#include "webs.hpp"

#include <gtest/gtest.h>

namespace gonio {
namespace {

using std::numbers::pi;
using test::flux_by_midpoints;
using test::random_web;
using test::steps;

TEST(Flux, OfAnIsotropicWebIsFourPi) {
    for (const std::size_t rows : {2U, 3U, 37U, 1801U}) {
        const Web web = *Web::create(Symmetry::axial, {0}, steps(0, 180, rows), std::vector<double>(rows, 100.0));
        EXPECT_NEAR(flux(web).value, 400.0 * pi, 1e-11);
        EXPECT_NEAR(zonal_flux(web).value, 400.0 * pi, 1e-11);
    }
}

TEST(Flux, OfOneLinearCellIsItsClosedForm) {
    // ∫₀^π/2 (1 − 2γ/π) sinγ dγ = 1 − 2/π
    const Web web = *Web::create(Symmetry::axial, {0}, {0, 90}, {1, 0});
    EXPECT_NEAR(flux(web).value, 2.0 * pi * (1.0 - 2.0 / pi), 1e-15 * 10);
}

// Steps of 5° in C include every plane below, and the midpoint rule is exact between planes, where the light is linear;
// in γ its error falls with the square of the step and is below 1e-7 at 2000 points per cell.
TEST(Flux, AgreesWithQuadratureForEverySymmetry) {
    for (const auto& gammas : {steps(0, 180, 19), std::vector<double>{0, 3, 4, 20, 55, 90}}) {
        for (const Web& web :
             {random_web(Symmetry::axial, {0}, gammas, 1), random_web(Symmetry::quadrant, steps(0, 90, 7), gammas, 2),
              random_web(Symmetry::bilateral_0_180, {0, 15, 20, 90, 180}, gammas, 3),
              random_web(Symmetry::bilateral_90_270, steps(90, 270, 13), gammas, 4),
              random_web(Symmetry::none, steps(0, 360, 25), gammas, 5)}) {
            const double truth = flux_by_midpoints(web, 72, 2000);
            EXPECT_NEAR(flux(web).value, truth, 1e-7 * truth) << to_text(web.stored_symmetry());
        }
    }
}

TEST(Flux, ScalesAndSplits) {
    const Web web = random_web(Symmetry::quadrant, steps(0, 90, 7), steps(0, 90, 19), 9);
    EXPECT_NEAR(flux(web.scaled(3.5)).value, 3.5 * flux(web).value, 1e-12 * flux(web).value);
    // Grid lines that only repeat the interpolant change nothing.
    std::vector<double> gammas = steps(0, 90, 19);
    gammas.insert(gammas.begin() + 3, 12.34);
    std::vector<double> candela;
    for (const double plane : web.planes_deg())
        for (const double gamma : gammas)
            candela.push_back(web.candela(plane, gamma));
    const Web split = *Web::create(Symmetry::quadrant, steps(0, 90, 7), gammas, candela);
    EXPECT_NEAR(flux(split).value, flux(web).value, 1e-12 * flux(web).value);
}

TEST(Flux, NarrowIntervalsDoNotCancel) {
    // w = γ near γ = 1: ∫ γ sinγ over an interval of width ε is ε·sin 1 to second order.
    for (const double width : {1e-3, 1e-6, 1e-9}) {
        const double low = 1.0 - 0.5 * width;
        const double high = 1.0 + 0.5 * width;
        const double real_width = high - low;
        EXPECT_NEAR(integrate_linear_sin(low, high, low, high), real_width * std::sin(1.0),
                    real_width * (width * width + 1e-15));
    }
    // The series and the textbook bracket meet at h = ½.
    const double below = integrate_linear_sin(0.5, 0.5 + 2 * 0.4999999999, 0.0, 1.0);
    const double above = integrate_linear_sin(0.5, 0.5 + 2 * 0.5000000001, 0.0, 1.0);
    EXPECT_NEAR(below, above, 1e-9);
    const auto antiderivative = [](double x) { return std::sin(x) - x * std::cos(x); };
    for (const double h : {0.1, 0.3, 0.499, 0.501, 1.2}) {
        const double a = 0.2;
        const double b = a + 2 * h;
        EXPECT_NEAR(integrate_linear_sin(a, b, a, b), antiderivative(b) - antiderivative(a), 4e-15);
    }
}

} // namespace
} // namespace gonio
