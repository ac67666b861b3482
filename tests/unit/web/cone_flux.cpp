// ConeFlux against closed forms and against quadrature in C and γ (Rings), which shares no step with ConeFlux.
#include <gonio/web/cone_flux.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/rings.hpp>

#include "webs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace gonio {
namespace {

using std::numbers::pi;
using test::steps;

Web random_goniometer(Photometry type, Symmetry symmetry, const std::vector<double>& horizontal,
                      const std::vector<double>& vertical, unsigned seed) {
    std::mt19937 engine(seed);
    std::vector<double> candela(horizontal.size() * vertical.size());
    for (double& value : candela)
        value = 1000.0 * static_cast<double>(engine()) / static_cast<double>(std::mt19937::max());
    return *Web::create(type, symmetry, horizontal, vertical, candela);
}

std::vector<Web> goniometers() {
    std::vector<Web> webs;
    for (const Photometry type : {Photometry::a, Photometry::b}) {
        webs.push_back(random_goniometer(type, Symmetry::none, steps(-90, 90, 13), steps(-90, 90, 19), 1));
        webs.push_back(random_goniometer(type, Symmetry::none, {-35, -20, 5, 61}, {-72, -3, 14, 40}, 2));
        webs.push_back(random_goniometer(type, Symmetry::quadrant, {0, 20, 60}, {0, 30, 80}, 3));
    }
    return webs;
}

TEST(ConeFlux, OfOneCandelaEverywhereInFrontIsTheSolidAngle) {
    for (const Photometry type : {Photometry::a, Photometry::b}) {
        const Web web = *Web::create(type, Symmetry::quadrant, {0, 90}, {0, 90}, {1, 1, 1, 1});
        const ConeFlux cones(web);
        for (const double gamma : {1e-3, 1.0, 30.0, 60.0, 89.0, 89.9999, 90.0}) {
            const ConeFlux::Halves lumens = cones.zone(0.0, gamma);
            const double half = 2.0 * pi * std::pow(std::sin(0.5 * gamma * pi / 180.0), 2.0);
            // The rule's own error is largest where a wide cone turns at the poles; a narrow cone is a difference of
            // integrals of size γ.
            const double tolerance = 5e-12 * half + 1e-15 * std::sqrt(half);
            EXPECT_NEAR(lumens.front, half, tolerance) << gamma;
            EXPECT_NEAR(lumens.back, half, tolerance) << gamma;
        }
        EXPECT_EQ(cones.zone(90.0, 180.0).both(), 0.0);
        EXPECT_EQ(cones.zone(97.0, 123.0).both(), 0.0);
    }
}

TEST(ConeFlux, TheWholeSphereHasTheFlux) {
    for (const Web& web : goniometers()) {
        const double all = flux(web).value;
        EXPECT_NEAR(ConeFlux(web).zone(0.0, 180.0).both(), all, 1e-9 * all);
    }
}

// Rings are stated to 1e-6 for tables of random values.
TEST(ConeFlux, MeetsTheQuadrature) {
    constexpr std::array edges{0.0, 90.0, 270.0, 360.0};
    for (const Web& web : goniometers()) {
        const double all = flux(web).value;
        const ConeFlux cones(web);
        const Rings rings(web);
        for (const auto& [low, high] : {std::pair{0.0, 10.0}, {12.5, 12.6}, {0.0, 72.0}, {60.0, 90.0}, {85.0, 133.0}}) {
            std::array<double, 3> lumens{};
            rings.add(low, high, edges, lumens);
            const ConeFlux::Halves halves = cones.zone(low, high);
            EXPECT_NEAR(halves.front, lumens[0] + lumens[2], 1e-6 * all) << low << ' ' << high;
            EXPECT_NEAR(halves.back, lumens[1], 1e-6 * all) << low << ' ' << high;
        }
    }
}

TEST(ConeFlux, ZonesAddUp) {
    for (const Web& web : goniometers()) {
        const ConeFlux cones(web);
        const double whole = cones.zone(5.0, 150.0).both();
        double sum = 0.0;
        for (int i = 0; i < 29; ++i)
            sum += cones.zone(5.0 + 5.0 * i, 10.0 + 5.0 * i).both();
        EXPECT_NEAR(sum, whole, 1e-9 * whole);
    }
}

} // namespace
} // namespace gonio
