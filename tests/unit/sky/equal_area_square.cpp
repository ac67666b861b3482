#include <gonio/sky/environment_map.hpp>
#include <gonio/sky/equal_area_square.hpp>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace gonio {
namespace {

using std::numbers::pi;

// Luminances that differ from texel to texel, and channel to channel.
EnvironmentMap uneven(int width, int height) {
    const EnvironmentGrid grid = EnvironmentGrid::create(EnvironmentLayout::latlong, width, height).value();
    Image image(width, height, 3);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<float>(1 + (i * 7919) % 101);
    return EnvironmentMap::of_valid(grid, std::move(image), 2.0);
}

TEST(EqualAreaSquare, KeepsTheLightOfEveryChannel) {
    const EnvironmentMap source = uneven(32, 16);
    const glm::dvec3 light = source.light() / source.nits_per_unit();
    for (const int side : {1, 6, 37}) {
        const Image square = equal_area_square(source, side);
        glm::dvec3 sum(0.0);
        for (std::size_t i = 0; i < square.pixels.size(); ++i)
            sum[static_cast<int>(i % 3)] += static_cast<double>(square.pixels[i]);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(sum[c] * 4.0 * pi / (side * side), light[c], 1e-6 * light[c]) << side;
    }
}

TEST(EqualAreaSquare, AUniformImageStaysUniform) {
    const EnvironmentGrid grid = EnvironmentGrid::create(EnvironmentLayout::latlong, 24, 12).value();
    Image image(24, 12, 3);
    std::fill(image.pixels.begin(), image.pixels.end(), 3.5F);
    const Image square = equal_area_square(EnvironmentMap::of_valid(grid, std::move(image), 1.0), 19);
    for (const float value : square.pixels)
        EXPECT_NEAR(static_cast<double>(value), 3.5, 1e-6);
}

// A single bright texel, all around: its light lies where the mapping puts its middle.
TEST(EqualAreaSquare, PutsDirectionsWhereTheMappingHasThem) {
    constexpr int height = 16;
    constexpr int side = 128;
    const EnvironmentGrid grid = EnvironmentGrid::create(EnvironmentLayout::latlong, 2 * height, height).value();
    for (int row = 0; row < height; row += 5)
        for (int column = 0; column < 2 * height; column += 5) {
            Image image(2 * height, height, 3);
            image.at(column, row)[1] = 1.0F;
            const Image square = equal_area_square(EnvironmentMap::of_valid(grid, std::move(image), 1.0), side);
            const glm::dvec3 d = grid.direction({column + 0.5, row + 0.5});
            const double r = std::sqrt(1.0 - std::abs(d.z));
            double v = r * std::atan2(std::abs(d.y), std::abs(d.x)) * 2.0 / pi;
            double u = r - v;
            if (d.z < 0.0) {
                std::swap(u, v);
                u = 1.0 - u;
                v = 1.0 - v;
            }
            const auto texel = [&](double at) { return static_cast<int>(0.5 * (1.0 + at) * side); };
            // At the poles it covers a part of a texel.
            EXPECT_GT(square.at(texel(std::copysign(u, d.x)), texel(std::copysign(v, d.y)))[1], 0.3F)
                << column << ' ' << row;
        }
}

} // namespace
} // namespace gonio
