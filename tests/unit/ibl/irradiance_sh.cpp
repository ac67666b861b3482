#include <gonio/ibl/irradiance_sh.hpp>
#include <gonio/sky/environment_resample.hpp>
#include <gonio/sky/sky.hpp>
#include <gonio/sky/sky_description.hpp>

#include "../environments.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace gonio {
namespace {

using test::directions;
using test::filled;
using test::sky_map;

using std::numbers::pi;

EnvironmentGrid grid_of(EnvironmentLayout layout, int side) {
    return *environment_grid(layout, side);
}

TEST(SphericalHarmonics, AreOrthonormal) {
    // Many directions of equal solid angle integrate polynomials of degree 6 to about 1e-4.
    constexpr int count = 20000;
    std::array<std::array<double, 16>, 16> products{};
    for (const glm::dvec3& d : directions(count)) {
        const std::array<double, 16> y = spherical_harmonics(d);
        for (std::size_t i = 0; i < 16; ++i)
            for (std::size_t j = 0; j < 16; ++j)
                products.at(i).at(j) += 4.0 * pi / count * y.at(i) * y.at(j);
    }
    for (std::size_t i = 0; i < 16; ++i)
        for (std::size_t j = 0; j < 16; ++j)
            EXPECT_NEAR(products.at(i).at(j), i == j ? 1.0 : 0.0, 5e-4) << i << ' ' << j;
}

TEST(IrradianceSh, OfUniformLightIsItsFirstCoefficient) {
    for (const EnvironmentLayoutInfo& info : environment_layouts())
        for (const int side : {2, 8}) {
            const IrradianceSh sh = irradiance_sh(filled(grid_of(info.layout, side), 100.0F), 3);
            EXPECT_NEAR(sh.radiance()[0].g, 100.0 * std::sqrt(4.0 * pi), 1e-9) << info.name;
            for (std::size_t i = 1; i < sh.radiance().size(); ++i)
                EXPECT_NEAR(sh.radiance()[i].g, 0.0, 1e-7) << info.name << ' ' << i;
            EXPECT_NEAR(sh.irradiance({0.6, 0.0, 0.8}).r, 100.0 * pi, 1e-6) << info.name;
        }
}

// The light of one small texel is that of a direction: its coefficients are the harmonics there.
TEST(IrradianceSh, OfOneDirectionIsTheHarmonicsOfIt) {
    for (const EnvironmentLayoutInfo& info : environment_layouts()) {
        const EnvironmentGrid grid = grid_of(info.layout, 128);
        EnvironmentMap map = filled(grid, 0.0F);
        const TexelIndex texel = grid.texel_at({0.3, -0.4, 0.8660254});
        Image image = map.image();
        image.at(texel.column, texel.row)[1] = 1000.0F;
        map = EnvironmentMap::of_valid(grid, std::move(image), 2.0);
        const glm::dvec3 there = glm::normalize(grid.direction_integral(texel));
        const double light = 2000.0 * grid.solid_angle(texel);
        const IrradianceSh sh = irradiance_sh(map, 3);
        const std::array<double, 16> y = spherical_harmonics(there);
        for (std::size_t i = 0; i < 16; ++i) {
            // The widest texels, of an octahedral, span 1.5°: the second order is l(l + 1)/2 times a mean square of
            // 1e-4.
            EXPECT_NEAR(sh.radiance()[i].g, light * y.at(i), 6e-4 * light) << info.name << ' ' << i;
            EXPECT_EQ(sh.radiance()[i].r, 0.0);
        }
        // E of l ≤ 2 towards the light: (1/4 + 1/2 + 5/16) of it; away from it 1/4 − 1/2 + 5/16.
        EXPECT_NEAR(sh.irradiance(there).g, 17.0 / 16.0 * light, 6e-4 * light) << info.name;
        EXPECT_NEAR(sh.irradiance(-there).g, light / 16.0, 6e-4 * light) << info.name;
        // 1/4 + cos/2 + 5/32 (3 cos² − 1) is least at cos = −8/15.
        EXPECT_LT(sh.least().g, 0.0) << info.name;
        EXPECT_NEAR(sh.least().g, (0.25 - 0.5 * 8.0 / 15.0 + 5.0 / 32.0 * (3.0 * 64.0 / 225.0 - 1.0)) * light,
                    1e-3 * light)
            << info.name;
    }
}

TEST(IrradianceSh, OfOrderThreeAddsNothingToAnIrradiance) {
    const EnvironmentMap map = sky_map("cie:12,sun=180/40,horizontal=20klx", EnvironmentLayout::latlong, 32);
    const IrradianceSh two = irradiance_sh(map, 2);
    const IrradianceSh three = irradiance_sh(map, 3);
    EXPECT_EQ(two.radiance().size(), 9U);
    EXPECT_EQ(three.radiance().size(), 16U);
    EXPECT_GT(std::abs(three.radiance()[12].g), 1.0);
    EXPECT_EQ(three.irradiance_coefficients()[12].g, 0.0);
    for (const glm::dvec3& n : directions(20))
        EXPECT_EQ(two.irradiance(n), three.irradiance(n));
}

// Sums of nested adaptive quadrature for the skies themselves: the error of l ≤ 2 over all normals, greatest and root
// mean square, in % of the greatest E. The figures have two digits.
TEST(IrradianceSh, ErrsAsPublishedForTheSkiesOfTheCie) {
    struct Row {
        std::string_view sky;
        double greatest;
        double rms;
    };
    constexpr std::array rows{
        Row{"cie:1,sun=180/40,horizontal=20klx", 0.54, 0.17}, Row{"cie:7,sun=180/30,horizontal=20klx", 0.97, 0.40},
        Row{"cie:12,sun=180/40,horizontal=20klx", 1.13, 0.48}, Row{"cie:12,sun=180/15,horizontal=20klx", 2.67, 0.98},
        Row{"cie:15,sun=180/40,horizontal=20klx", 1.49, 0.64}};
    const std::vector<glm::dvec3> normals = directions(1500);
    for (const Row& row : rows) {
        const EnvironmentMap map = sky_map(std::string(row.sky), EnvironmentLayout::cube_strip, 32);
        const IrradianceSh sh = irradiance_sh(map, 2);
        const std::vector<glm::dvec3> exact = map.irradiance(normals);
        double most = 0.0;
        double greatest = 0.0;
        double squares = 0.0;
        for (std::size_t i = 0; i < normals.size(); ++i) {
            const double error = std::abs(sh.irradiance(normals[i]).g - exact[i].g);
            most = std::max(most, exact[i].g);
            greatest = std::max(greatest, error);
            squares += error * error;
        }
        EXPECT_NEAR(100.0 * greatest / most, row.greatest, 0.02 + 0.02 * row.greatest) << row.sky;
        EXPECT_NEAR(100.0 * std::sqrt(squares / static_cast<double>(normals.size())) / most, row.rms, 0.015) << row.sky;
    }
}

TEST(IrradianceSh, DoesNotDependOnThreadsOrLayout) {
    const EnvironmentMap map =
        sky_map("cie:12,sun=180/40,horizontal=20klx,ground=0.2", EnvironmentLayout::cube_strip, 32);
    const IrradianceSh one = irradiance_sh(map, 3, 1);
    const IrradianceSh three = irradiance_sh(map, 3, 3);
    for (std::size_t i = 0; i < 16; ++i)
        EXPECT_EQ(one.radiance()[i], three.radiance()[i]);
    const IrradianceSh other =
        irradiance_sh(sky_map("cie:12,sun=180/40,horizontal=20klx,ground=0.2", EnvironmentLayout::octahedral, 64), 3);
    for (std::size_t i = 0; i < 16; ++i)
        EXPECT_NEAR(one.radiance()[i].g, other.radiance()[i].g, 2e-3 * one.radiance()[0].g) << i;
}

} // namespace
} // namespace gonio
