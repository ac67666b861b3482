#include <gonio/light/light_color.hpp>
#include <gonio/sky/blurred_sky.hpp>
#include <gonio/sky/environment_resample.hpp>
#include <gonio/sky/sky_direction.hpp>

#include "../environments.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

namespace gonio {
namespace {

using test::directions;

using Vec = glm::dvec3;
using std::numbers::pi;

// An image sky of this luminance towards each direction.
Sky painted(EnvironmentLayout layout, int side, const std::function<double(const Vec&)>& nt, const char* keys = "") {
    const EnvironmentGrid grid = environment_grid(layout, side).value();
    Image image;
    image.width = grid.width();
    image.height = grid.height();
    image.channels = 3;
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            const auto value =
                static_cast<float>(grid.covers({column, row}) ? nt(grid.direction({column + 0.5, row + 0.5})) : 0.0);
            image.pixels.insert(image.pixels.end(), 3, value);
        }
    auto map = std::make_shared<const EnvironmentMap>(EnvironmentMap::of_valid(grid, std::move(image), 1.0));
    return resolve_sky(parse_sky_description(std::string("image:painted") + keys).value(), std::move(map)).value();
}

constexpr EnvironmentLayout all_layouts[] = {EnvironmentLayout::latlong, EnvironmentLayout::cube_cross,
                                             EnvironmentLayout::cube_cross_vertical, EnvironmentLayout::cube_strip,
                                             EnvironmentLayout::octahedral};
constexpr double widths[] = {0.0, 0.02, 0.05, 0.1, 0.2, 0.4, 1.0, 3.0};

TEST(BlurredSky, KeepsAnEvenImageEven) {
    for (const EnvironmentLayout layout : all_layouts)
        for (const int side : {8, 64}) {
            const BlurredSky sky(painted(layout, side, [](const Vec&) { return 70.0; }));
            for (const Vec& direction : directions(500))
                for (const double width : widths)
                    EXPECT_NEAR(sky.radiance(direction, width).y, 70.0, 7e-5) << info_of(layout).name << width;
        }
}

// A window of 12° by 12°: the mean over all directions is that of the image however far it is spread.
TEST(BlurredSky, KeepsTheLightOfAWindow) {
    for (const EnvironmentLayout layout : all_layouts) {
        const Sky source = painted(layout, 128, [](const Vec& d) {
            return std::abs(d.z - 0.4) < 0.1 && std::abs(std::atan2(d.x, d.y) - 2.0) < 0.1 ? 5000.0 : 10.0;
        });
        const double mean = source.light().y / (4.0 * pi);
        const BlurredSky sky(source);
        for (const double width : widths) {
            double sum = 0.0;
            const std::vector<Vec> all = directions(40000);
            for (const Vec& direction : all)
                sum += sky.radiance(direction, width).y;
            // Bilinear lookups weigh a texel by more or less than its solid angle: most for the 96 largest.
            EXPECT_NEAR(sum / static_cast<double>(all.size()), mean, (width < 0.3 ? 0.02 : 0.12) * mean)
                << info_of(layout).name << ' ' << width;
        }
    }
}

// The narrowest spot is the image itself; a wide one no longer shows the window.
TEST(BlurredSky, SpreadsWithTheWidth) {
    const auto window = [](const Vec& d) { return glm::dot(d, Vec(0.6, 0.0, 0.8)) > 0.995 ? 1000.0 : 0.0; };
    const Sky source = painted(EnvironmentLayout::latlong, 256, window);
    const BlurredSky sky(source);
    const Vec middle(0.6, 0.0, 0.8);
    EXPECT_EQ(sky.radiance(middle, 0.001), source.radiance(middle));
    double last = 1000.0;
    for (const double width : {0.05, 0.2, 0.4, 0.8}) {
        const double nt = sky.radiance(middle, width).y;
        EXPECT_LE(nt, last * (1.0 + 1e-6)) << width; // floats
        last = nt;
    }
    EXPECT_LT(last, 150.0);
}

TEST(BlurredSky, KeepsSkyAndGroundApart) {
    const BlurredSky sky(painted(EnvironmentLayout::latlong, 64, [](const Vec& d) { return d.z > 0.0 ? 100.0 : 3.0; }));
    for (const double width : {0.05, 0.1, 0.3, 1.0})
        for (const Vec& direction : directions(2000))
            EXPECT_NEAR(sky.radiance(direction, width).y, direction.z >= 0.0 ? 100.0 : 3.0, 1e-3) << width;
}

TEST(BlurredSky, TurnsAndScalesWithTheSky) {
    const auto uneven = [](const Vec& d) { return 50.0 + 30.0 * d.x + 10.0 * d.y; };
    const BlurredSky plain(painted(EnvironmentLayout::octahedral, 128, uneven));
    const Sky changed = painted(EnvironmentLayout::octahedral, 128, uneven, ",rotate=70deg,horizontal=1klx");
    const BlurredSky turned_sky(changed);
    for (const Vec& direction : directions(200))
        for (const double width : {0.1, 0.5})
            EXPECT_NEAR(turned_sky.radiance(direction, width).y,
                        changed.image_scale() * plain.radiance(turned(direction, Radians(-70.0 * pi / 180.0)), width).y,
                        1e-3);
}

TEST(BlurredSky, LeavesFormulasAsTheyAre) {
    const Sky clear = resolve_sky(parse_sky_description("cie:12,sun=120/40,horizontal=20klx").value()).value();
    const BlurredSky sky(clear);
    for (const Vec& direction : directions(50))
        EXPECT_EQ(sky.radiance(direction, 0.3), clear.radiance(direction));
    EXPECT_EQ(BlurredSky(Sky()).radiance({0.0, 0.0, 1.0}, 0.1), Vec(0.0));
}

TEST(BlurredSky, IsTheSameForAnyNumberOfThreads) {
    const Sky source = painted(EnvironmentLayout::latlong, 64, [](const Vec& d) { return 5.0 + d.x * d.y + d.z; });
    const BlurredSky one(source, 1);
    const BlurredSky many(source, 5);
    for (const Vec& direction : directions(300))
        EXPECT_EQ(one.radiance(direction, 0.2), many.radiance(direction, 0.2));
}

} // namespace
} // namespace gonio
