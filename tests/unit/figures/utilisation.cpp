// Utilisation of a Lambertian luminaire: values of the closed form factors, and the printed zonal cavity formula.
#include <gonio/figures/utilisation.hpp>
#include <gonio/web/direct_ratios.hpp>
#include <gonio/web/zones.hpp>

#include "lambertian.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace gonio {
namespace {

std::size_t column_of(double ceiling, double walls) {
    for (std::size_t i = 0; i < utilisation_reflectances.size(); ++i)
        if (utilisation_reflectances[i].ceiling == ceiling && utilisation_reflectances[i].walls == walls) return i;
    throw std::logic_error("no such column");
}

TEST(UtilisationFactors, OfALambertianLuminaire) {
    const Web web = test::lambertian_web(1000.0);
    const UtilisationFactors factors = utilisation_factors(ten_degree_zones(web), direct_ratios(web), Lumens(1000.0));
    const auto expect = [&](double ceiling, double walls, const std::array<double, 10>& values) {
        for (std::size_t k = 0; k < values.size(); ++k)
            EXPECT_NEAR(factors[k][column_of(ceiling, walls)], values[k], 1.5e-4) << ceiling << ' ' << k;
    };
    expect(0.0, 0.0, {.2508, .3411, .4153, .4892, .5474, .6320, .6902, .7326, .7900, .8270});
    expect(0.7, 0.5, {.4177, .5224, .6039, .6820, .7415, .8255, .8818, .9220, .9756, 1.0096});
    expect(0.5, 0.3, {.3283, .4266, .5058, .5836, .6443, .7321, .7922, .8359, .8950, .9331});
    expect(0.3, 0.3, {.3229, .4184, .4949, .5697, .6278, .7113, .7681, .8091, .8644, .8999});
}

TEST(UtilisationCoefficients, OfLambertianLuminaires) {
    constexpr std::array<double, 11> down{1.1905, 1.0264, .8871, .7743, .6830, .6082,
                                          .5462,  .4943,  .4503, .4128, .3805};
    constexpr std::array<double, 11> direct{1, .8182, .6712, .5589, .4730, .4062, .3533, .3108, .2761, .2475, .2235};
    const auto zones = ten_degree_zones(test::lambertian_web(1000.0));
    const UtilisationCoefficients coefficients = utilisation_coefficients(zones, Lumens(1000.0));
    for (std::size_t rcr = 0; rcr < 11; ++rcr) {
        EXPECT_NEAR(coefficients[rcr][1], down[rcr], 1e-4) << rcr;
        EXPECT_NEAR(zonal_direct_ratio(zones, static_cast<double>(rcr)), direct[rcr], 1e-4) << rcr;
    }
    const UtilisationCoefficients up =
        utilisation_coefficients(ten_degree_zones(test::lambertian_web(1000.0, 0.125, true)), Lumens(1000.0));
    constexpr std::array<double, 7> upward{.9524, .8260, .7207, .6317, .5563, .4922, .4377};
    for (std::size_t rcr = 0; rcr < upward.size(); ++rcr)
        EXPECT_NEAR(up[rcr][1], upward[rcr], 1e-4) << rcr;
}

// The formula that the IES prints, in its own three terms, for every column with walls that reflect.
TEST(UtilisationCoefficients, EqualTheFormulaOfTheHandbook) {
    const Web web = *Web::create(Symmetry::axial, {0.0}, {0.0, 40.0, 90.0, 130.0, 180.0}, {500, 300, 90, 60, 20});
    const auto zones = ten_degree_zones(web);
    double down = 0.0;
    double up = 0.0;
    for (std::size_t i = 0; i < 18; ++i)
        (i < 9 ? down : up) += zones[i].value / 1000.0;
    const UtilisationCoefficients coefficients = utilisation_coefficients(zones, Lumens(1000.0));
    for (int rcr = 1; rcr <= 10; ++rcr)
        for (std::size_t column = 0; column < cu_reflectances.size(); ++column) {
            const auto [c, w, f] = cu_reflectances[column];
            if (w == 0.0) continue;
            const double form = facing_rectangles_form_factor(10.0 / rcr, 10.0 / rcr);
            const double c1 = (1 - w) * (1 - form * form) * rcr / (2.5 * w * (1 - form * form) + rcr * form * (1 - w));
            const double c2 = (1 - c) * (1 + form) / (1 + c * form);
            const double c3 = (1 - f) * (1 + form) / (1 + f * form);
            const double c0 = c1 + c2 + c3;
            const double d = zonal_direct_ratio(zones, rcr);
            const double expected = 2.5 * w * c1 * c3 * (1 - d) * down / (rcr * (1 - w) * (1 - f) * c0) +
                                    c * c2 * c3 * up / ((1 - c) * (1 - f) * c0) +
                                    (1 - f * c3 * (c1 + c2) / ((1 - f) * c0)) * d * down / (1 - f);
            EXPECT_NEAR(coefficients[static_cast<std::size_t>(rcr)][column], expected, 1e-12) << rcr << ' ' << column;
        }
}

} // namespace
} // namespace gonio
