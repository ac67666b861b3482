// Masks of types A and B: against sums over directions that use no grid.
#include <gonio/light/lobe.hpp>
#include <gonio/light/masked_flux.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace gonio {
namespace {

constexpr double pi = std::numbers::pi;

template<class Lobe>
double dense(const Web& web, Lobe&& lobe_of) {
    const int rows = 1000;
    const int columns = 1000;
    double sum = 0.0;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const double gamma = (j + 0.5) * 0.5 * pi / rows;
            const double c = (i + 0.5) * 2.0 * pi / columns;
            const glm::dvec3 direction = direction_of({Radians(c), Radians(gamma)});
            const double share = lobe_of(direction, gamma);
            if (share > 0.0) sum += share * web.candela(direction) * std::sin(gamma);
        }
    return sum * 0.5 * pi / rows * 2.0 * pi / columns / peak(web).intensity.value;
}

TEST(MaskedNative, AgreesWithDenseSums) {
    std::mt19937 generator(11);
    for (const Photometry type : {Photometry::a, Photometry::b}) {
        std::vector<double> candela(7 * 5);
        for (double& cd : candela)
            cd = static_cast<double>(generator()) / 4294967296.0;
        const Web web =
            *Web::create(type, Symmetry::none, {-80, -40, -15, 0, 10, 45, 80}, {-70, -20, 0, 25, 70}, candela);
        const Shape point = PointShape{};
        EXPECT_NEAR(masked_solid_angle(point, web).value, flux(web).value / peak(web).intensity.value, 1e-12);
        for (const Falloff falloff : {Falloff::hard, Falloff::frostbite, Falloff::smoothstep_angle}) {
            SpotShape spot;
            spot.outer = degrees(36.0);
            spot.inner = degrees(12.0);
            spot.falloff = falloff;
            const double truth = dense(web, [&](const glm::dvec3&, double g) { return lobe(spot, Radians(g)); });
            EXPECT_NEAR(masked_solid_angle(Shape(spot), web).value, truth, 1e-3 * truth);
        }
        FrustumShape frustum;
        frustum.horizontal = degrees(60.0);
        frustum.vertical = degrees(34.0);
        const double truth = dense(web, [&](const glm::dvec3& d, double) { return lobe(frustum, d); });
        EXPECT_NEAR(masked_solid_angle(Shape(frustum), web).value, truth, 1e-3 * truth);
    }
}

} // namespace
} // namespace gonio
