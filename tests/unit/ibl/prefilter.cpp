#include <gonio/ibl/environment_tree.hpp>
#include <gonio/ibl/prefilter.hpp>
#include <gonio/ibl/prefilter_error.hpp>
#include <gonio/ibl/prefilter_methods.hpp>
#include <gonio/ibl/prefilter_variant.hpp>
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

constexpr std::array roughnesses{0.02, 0.1, 0.25, 0.5, 0.75, 1.0};

// Every texel another colour: the roughest of all images, from a fixed sequence.
EnvironmentMap speckled(EnvironmentLayout layout, int side) {
    const EnvironmentGrid grid = *environment_grid(layout, side);
    Image image(grid.width(), grid.height(), 3);
    std::uint32_t state = 12345;
    for (float& value : image.pixels) {
        state = state * 1664525U + 1013904223U;
        value = static_cast<float>(state >> 8U) * 0x1p-24F;
        value *= value * 100.0F;
    }
    return EnvironmentMap::of_valid(grid, std::move(image), 1.0);
}

double greatest_difference(std::span<const glm::dvec3> a, std::span<const glm::dvec3> b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int c = 0; c < 3; ++c)
            most = std::max(most, std::abs(a[i][c] - b[i][c]));
    return most;
}

std::vector<LobeQuery> queries(std::span<const glm::dvec3> around, double roughness) {
    std::vector<LobeQuery> all;
    for (const glm::dvec3& d : around)
        all.push_back({d, roughness});
    return all;
}

TEST(GgxLobe, HasTheIntegralOfItsWeight) {
    for (const double r : {0.05, 0.3, 0.7, 0.9, 0.93, 0.95, 1.0}) {
        const GgxLobe lobe(r);
        for (const double u : {0.01, 0.3, 0.9}) {
            const double step = 1e-4 * u;
            EXPECT_NEAR((lobe.integral(u + step) - lobe.integral(u - step)) / (2.0 * step) / lobe.weight(u), 1.0, 1e-6);
            EXPECT_NEAR((lobe.weight(u - step) - lobe.weight(u + step)) / (2.0 * step) / lobe.slope(u), 1.0, 1e-5);
        }
        EXPECT_DOUBLE_EQ(lobe.whole(), 2.0 * pi * lobe.integral(1.0));
        EXPECT_EQ(lobe.weight(1.1), 0.0);
    }
    // Lambert's cosine.
    EXPECT_NEAR(GgxLobe(1.0).weight(0.25), 0.75 / pi, 1e-15);
    EXPECT_NEAR(GgxLobe(1.0).whole(), 1.0, 1e-15);
}

// The shares of all texels are the whole lobe: every texel's share is then in doubt only by what another one lacks.
TEST(PrefilteredByQuadrature, HasTheWholeLobe) {
    const std::vector<glm::dvec3> around = directions(7);
    for (const EnvironmentLayoutInfo& info : environment_layouts())
        for (const double roughness : roughnesses)
            for (const glm::dvec3& mean : prefiltered_by_quadrature(filled(*environment_grid(info.layout, 16), 1.0F),
                                                                    queries(around, roughness)))
                EXPECT_NEAR(mean.g, 1.0, 1e-7) << info.name << ' ' << roughness;
}

TEST(PrefilteredByQuadrature, OfRoughnessOneIsTheIrradiance) {
    const std::vector<glm::dvec3> around = directions(9);
    for (const EnvironmentLayout layout : {EnvironmentLayout::cube_cross, EnvironmentLayout::octahedral}) {
        const EnvironmentMap map = speckled(layout, 16);
        std::vector<glm::dvec3> exact = map.irradiance(around);
        for (glm::dvec3& e : exact)
            e /= pi;
        EXPECT_LT(greatest_difference(prefiltered_by_quadrature(map, queries(around, 1.0)), exact), 1e-7 * 33.0);
    }
}

// Samples that are drawn from the lobe find the same mean: 2^18 Hammersley points on an image of steps.
TEST(PrefilteredByQuadrature, AgreesWithManySamples) {
    const EnvironmentMap map =
        sky_map("cie:12,sun=180/40,horizontal=20klx,ground=0.2", EnvironmentLayout::cube_strip, 32);
    const std::vector<glm::dvec3> around = directions(5);
    for (const double roughness : {0.1, 0.3, 0.6, 0.9}) {
        const std::vector<glm::dvec3> exact = prefiltered_by_quadrature(map, queries(around, roughness));
        for (std::size_t i = 0; i < around.size(); ++i) {
            const glm::dvec3 sampled = prefiltered_by_samples(map, {around[i], roughness}, 1 << 18);
            EXPECT_NEAR(sampled.g / exact[i].g, 1.0, 4e-4) << roughness << ' ' << i;
        }
    }
}

TEST(EnvironmentTree, IsAsGoodAsItsTolerance) {
    struct Case {
        EnvironmentMap map;
        double most; // of the mean, at a tolerance of 1e-6
    };
    const std::array cases{
        Case{sky_map("cie:12,sun=180/40,horizontal=20klx,ground=0.2", EnvironmentLayout::cube_strip, 32), 5e-4},
        Case{sky_map("cie:15,sun=100/3,horizontal=20klx", EnvironmentLayout::latlong, 32), 5e-4},
        Case{sky_map("cie:7,sun=180/30,horizontal=20klx", EnvironmentLayout::octahedral, 64), 5e-4},
        Case{speckled(EnvironmentLayout::cube_cross_vertical, 12), 5e-4}};
    const std::vector<glm::dvec3> around = directions(25);
    for (const Case& of : cases) {
        const EnvironmentTree tree(of.map);
        EXPECT_NEAR(tree.mean().g, of.map.light().g / (4.0 * pi), 1e-6 * tree.mean().g);
        for (const double roughness : roughnesses) {
            const std::vector<glm::dvec3> exact = prefiltered_by_quadrature(of.map, queries(around, roughness));
            std::array<double, 2> errors{};
            for (std::size_t i = 0; i < 2; ++i) {
                std::vector<glm::dvec3> found;
                for (const glm::dvec3& d : around)
                    found.push_back(tree.mean(GgxLobe(roughness), d, i == 0 ? 1e-3 : 1e-6));
                errors.at(i) = greatest_difference(found, exact) / tree.mean().g;
            }
            EXPECT_LT(errors[1], of.most) << roughness << ' ' << info_of(of.map.grid().layout()).name;
            EXPECT_LT(errors[0], 0.08) << roughness << ' ' << info_of(of.map.grid().layout()).name;
            EXPECT_LE(errors[1], errors[0] + 1e-6) << roughness << ' ' << info_of(of.map.grid().layout()).name;
        }
    }
}

// Leaves of 4×4 texels keep the light and its moments: wide lobes do not notice, and narrow ones see a blurred image.
TEST(EnvironmentTree, MayEndAtBlocksOfTexels) {
    const EnvironmentMap map =
        sky_map("cie:12,sun=180/40,horizontal=20klx,ground=0.2", EnvironmentLayout::cube_strip, 32);
    const EnvironmentTree whole(map);
    const EnvironmentTree blocks(map, 0, 6 * 32 * 32 / 16);
    EXPECT_LT(blocks.nodes(), whole.nodes() / 12);
    EXPECT_NEAR(blocks.mean().g, whole.mean().g, 1e-12 * whole.mean().g);
    for (const double roughness : {0.5, 0.75, 1.0})
        for (const glm::dvec3& d : directions(15))
            EXPECT_NEAR(blocks.mean(GgxLobe(roughness), d, 1e-6).g, whole.mean(GgxLobe(roughness), d, 1e-6).g,
                        4e-3 * whole.mean().g)
                << roughness;
}

TEST(EnvironmentTree, OfBlackIsBlack) {
    const EnvironmentTree tree(filled(*environment_grid(EnvironmentLayout::cube_strip, 4), 0.0F));
    EXPECT_EQ(tree.mean(GgxLobe(0.3), {0.0, 0.0, 1.0}, 1e-5), glm::dvec3(0.0));
}

TEST(Prefilter, KeepsAUniformEnvironmentUniform) {
    for (const EnvironmentLayoutInfo& info : environment_layouts()) {
        PrefilterOptions options;
        options.side = 16;
        options.levels = 4;
        options.layout = info.layout;
        const PrefilteredEnvironment levels =
            *prefilter(filled(*environment_grid(EnvironmentLayout::latlong, 16), 300.0F), options);
        ASSERT_EQ(levels.levels().size(), 4U);
        for (const PrefilteredLevel& level : levels.levels())
            for (int row = 0; row < level.map.grid().height(); ++row)
                for (int column = 0; column < level.map.grid().width(); ++column)
                    if (level.map.grid().covers({column, row})) {
                        // Level 0 is resampled.
                        EXPECT_NEAR(level.map.texel({column, row}).r, 300.0,
                                    300.0 * (level.roughness > 0.0 ? 1e-6 : 5e-6))
                            << info.name << ' ' << level.roughness;
                    }
    }
}

// The sky turned by a quarter gives the picture turned by a quarter.
TEST(Prefilter, TurnsWithItsSource) {
    const std::vector<glm::dvec3> around = directions(11);
    const EnvironmentMap south = sky_map("cie:12,sun=180/40,horizontal=20klx", EnvironmentLayout::cube_strip, 32);
    const EnvironmentMap west = sky_map("cie:12,sun=270/40,horizontal=20klx", EnvironmentLayout::cube_strip, 32);
    const EnvironmentTree of_south(south);
    const EnvironmentTree of_west(west);
    for (const double roughness : roughnesses)
        for (const glm::dvec3& d : around) {
            const GgxLobe lobe(roughness);
            // North over east: 90° more turn (x, y) into (y, −x).
            const glm::dvec3 turned(d.y, -d.x, d.z);
            EXPECT_NEAR(of_west.mean(lobe, turned, 1e-6).g, of_south.mean(lobe, d, 1e-6).g, 1e-5 * of_south.mean().g)
                << roughness;
        }
}

TEST(Prefilter, HasLevelsOfTheMapping) {
    PrefilterOptions options;
    options.side = 16;
    options.levels = 5;
    options.mapping = RoughnessMapping::filament;
    const EnvironmentMap map = sky_map("cie:12,sun=180/40,horizontal=20klx", EnvironmentLayout::cube_strip, 16);
    const PrefilteredEnvironment found = *prefilter(map, options);
    EXPECT_EQ(found.levels()[0].map.image().pixels, map.image().pixels);
    EXPECT_EQ(found.levels()[4].map.grid().side(), 1);
    EXPECT_DOUBLE_EQ(found.levels()[3].roughness, 0.5);
    EXPECT_DOUBLE_EQ(found.levels()[4].roughness, 1.0);
    // Between levels in the mapping's own measure.
    const glm::dvec3 direction(0.2, -0.5, 0.6);
    const double between = roughness_of(RoughnessMapping::filament, 2.25, 4);
    const glm::dvec3 expected =
        0.75 * found.levels()[2].map.radiance(direction) + 0.25 * found.levels()[3].map.radiance(direction);
    EXPECT_NEAR(found.radiance(direction, between).g, expected.g, 1e-9 * expected.g);
    EXPECT_EQ(found.radiance(direction, 1.0), found.levels()[4].map.radiance(direction));
    EXPECT_EQ(found.radiance(direction, 0.0), found.levels()[0].map.radiance(direction));
}

TEST(Prefilter, DoesNotDependOnThreads) {
    const EnvironmentMap map = speckled(EnvironmentLayout::latlong, 16);
    PrefilterOptions options;
    options.side = 8;
    options.levels = 3;
    options.threads = 1;
    const PrefilteredEnvironment one = *prefilter(map, options);
    options.threads = 3;
    const PrefilteredEnvironment three = *prefilter(map, options);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(one.levels()[i].map.image().pixels, three.levels()[i].map.image().pixels);
}

TEST(Prefilter, RefusesSizesThatHaveNoSuchLevels) {
    const EnvironmentMap map = filled(*environment_grid(EnvironmentLayout::cube_strip, 4), 1.0F);
    const auto is_refused = [&](EnvironmentLayout layout, int side, int levels) {
        PrefilterOptions options;
        options.layout = layout;
        options.side = side;
        options.levels = levels;
        return !prefilter(map, options);
    };
    EXPECT_TRUE(is_refused(EnvironmentLayout::cube_strip, 8, 5));
    EXPECT_TRUE(is_refused(EnvironmentLayout::cube_strip, 12, 4));
    EXPECT_TRUE(is_refused(EnvironmentLayout::octahedral, 8, 4));
    EXPECT_TRUE(is_refused(EnvironmentLayout::cube_strip, 8, 0));
    EXPECT_TRUE(is_refused(EnvironmentLayout::cube_strip, 1 << 20, 1));
    EXPECT_FALSE(is_refused(EnvironmentLayout::cube_strip, 8, 4));
}

TEST(PrefilterErrors, AreWhatWasDoneToALevel) {
    const EnvironmentMap map = speckled(EnvironmentLayout::cube_strip, 8);
    PrefilterOptions options;
    options.side = 8;
    options.levels = 3;
    options.tolerance = 1e-9;
    const PrefilteredEnvironment exact = *prefilter(map, options);
    std::vector<PrefilteredLevel> levels(exact.levels().begin(), exact.levels().end());
    std::vector<PrefilterError> errors = prefilter_errors(map, levels, 20);
    EXPECT_EQ(errors[0].texels, 0);
    EXPECT_EQ(errors[1].texels, 20);
    EXPECT_LT(errors[1].greatest, 1e-4);
    EXPECT_LT(errors[2].greatest, 1e-4);
    // All of a level brighter by a tenth of it.
    levels[1].map.set_nits_per_unit(1.1);
    errors = prefilter_errors(map, levels, 20);
    EXPECT_GT(errors[1].rms, 0.09);
    EXPECT_LT(errors[2].greatest, 1e-4);
}

TEST(PrefilterVariants, HaveTheirLevels) {
    for (const PrefilterVariant& variant : prefilter_variants()) {
        EXPECT_EQ(*parse_prefilter_variant(variant.name), &variant);
        EXPECT_GE(variant.side >> (levels_of(variant, variant.side, 1) - 1), 1);
    }
    EXPECT_EQ(levels_of(**parse_prefilter_variant("ue4"), 128, 1), 8);
    EXPECT_EQ(levels_of(**parse_prefilter_variant("ue4"), 96, 2), 6);
    EXPECT_FALSE(parse_prefilter_variant("unreal"));
}

TEST(IrradianceMap, IsTheIrradianceOverPi) {
    const EnvironmentMap map = sky_map("cie:12,sun=180/40,horizontal=20klx,ground=0.2", EnvironmentLayout::latlong, 32);
    const EnvironmentGrid to = *environment_grid(EnvironmentLayout::cube_strip, 4);
    const EnvironmentMap quick = irradiance_map(EnvironmentTree(map), to, 1e-6);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 24; column += 5) {
            const glm::dvec3 exact = map.irradiance(to.direction({column + 0.5, row + 0.5})) / pi;
            EXPECT_NEAR(quick.texel({column, row}).g, exact.g, 1e-4 * exact.g);
        }
}

} // namespace
} // namespace gonio
