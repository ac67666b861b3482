#include <gonio/light/light_color.hpp>
#include <gonio/sky/environment_layout.hpp>
#include <gonio/sky/sky_direction.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace gonio {
namespace {

using std::numbers::pi;

EnvironmentGrid grid(EnvironmentLayout layout, int side) {
    const EnvironmentLayoutInfo& info = info_of(layout);
    return EnvironmentGrid::create(layout, info.across * side, info.down * side).value();
}

// Values of numpy in float64.
TEST(EnvironmentLayout, LatLongTexels) {
    const EnvironmentGrid of = grid(EnvironmentLayout::latlong, 64);
    EXPECT_NEAR(of.solid_angle({0, 0}), 5.91279052618e-5, 1e-16);
    EXPECT_NEAR(of.solid_angle({5, 20}), 2.03553059781e-3, 1e-14);
    // Their azimuth counts from the first column's edge, which is south, to the west.
    const auto expect = [](const glm::dvec3& got, double along, double across, double up) {
        EXPECT_NEAR(got.y, -along, 1e-14);
        EXPECT_NEAR(got.x, -across, 1e-14);
        EXPECT_NEAR(got.z, up, 1e-14);
    };
    expect(of.direction_integral({0, 0}), 1.93363554289e-6, 4.74680882388e-8, 5.90922941861e-5);
    expect(of.direction_integral({5, 20}), 1.65723073817e-3, 4.58617510474e-4, 1.08867603738e-3);
}

TEST(EnvironmentLayout, CubeAndOctahedralTexels) {
    for (const EnvironmentLayout layout :
         {EnvironmentLayout::cube_cross, EnvironmentLayout::cube_cross_vertical, EnvironmentLayout::cube_strip}) {
        const int face = layout == EnvironmentLayout::cube_strip ? 0 : 1; // a row of faces that holds one in column 1
        EXPECT_NEAR(grid(layout, 4).solid_angle({4, 4 * face}), 0.0814555876, 6e-11);
        EXPECT_NEAR(grid(layout, 4).solid_angle({5, 4 * face + 1}), 0.2013579208, 6e-11);
        EXPECT_NEAR(grid(layout, 64).solid_angle({64, 64 * face}), 1.939315102e-4, 6e-14);
        EXPECT_NEAR(grid(layout, 64).solid_angle({95, 64 * face + 31}), 9.756099109e-4, 6e-14);
    }
    const EnvironmentGrid octahedral = grid(EnvironmentLayout::octahedral, 8);
    EXPECT_NEAR(octahedral.solid_angle({0, 0}), 0.1406929011, 6e-11);
    EXPECT_NEAR(octahedral.solid_angle({4, 0}), 0.1053118165, 6e-11);
    EXPECT_NEAR(octahedral.solid_angle({2, 2}), 0.2872357428, 6e-11);
}

// All texels together are the sphere, and those above a plane have E/L = π.
TEST(EnvironmentLayout, TexelsCoverTheSphere) {
    for (const EnvironmentLayoutInfo& info : environment_layouts())
        for (const int side : {4, 10, 64}) {
            const EnvironmentGrid of = grid(info.layout, side);
            double sphere = 0.0;
            glm::dvec3 net(0.0);
            double up = 0.0;
            double tilted = 0.0;
            const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, -0.5, 0.7));
            for (int row = 0; row < of.height(); ++row)
                for (int column = 0; column < of.width(); ++column) {
                    const TexelIndex texel{column, row};
                    if (!of.covers(texel)) continue;
                    sphere += of.solid_angle(texel);
                    net += of.direction_integral(texel);
                    up += of.direction_integral_above(texel, {0, 0, 1}).z;
                    tilted += glm::dot(of.direction_integral_above(texel, normal), normal);
                }
            EXPECT_NEAR(sphere, 4.0 * pi, 1e-11) << info.name << side;
            EXPECT_LT(glm::length(net), 1e-11) << info.name << side;
            // A coarse lat-long's parallels are chords where they are clipped.
            const double rounding = info.layout == EnvironmentLayout::latlong ? 1e-6 : 1e-11;
            EXPECT_NEAR(up, pi, side % 2 == 0 ? 1e-11 : rounding) << info.name << side;
            EXPECT_NEAR(tilted, pi, rounding) << info.name << side;
        }
}

// The direction integral by points spread over the texel.
TEST(EnvironmentLayout, IntegralsAreThoseOfPoints) {
    for (const EnvironmentLayoutInfo& info : environment_layouts()) {
        const EnvironmentGrid of = grid(info.layout, 8);
        for (int row = 0; row < of.height(); ++row)
            for (int column = 0; column < of.width(); ++column) {
                const TexelIndex texel{column, row};
                if (!of.covers(texel)) continue;
                // The area that the neighbouring points span on the sphere, around the middle of each cell.
                constexpr int n = 24;
                constexpr double h = 1e-4;
                glm::dvec3 sum(0.0);
                double area = 0.0;
                for (int i = 0; i < n; ++i)
                    for (int j = 0; j < n; ++j) {
                        const glm::dvec2 at(column + (i + 0.51) / n, row + (j + 0.5) / n);
                        const glm::dvec3 d = of.direction(at);
                        const glm::dvec3 x =
                            (of.direction(at + glm::dvec2(h, 0)) - of.direction(at - glm::dvec2(h, 0)));
                        const glm::dvec3 y =
                            (of.direction(at + glm::dvec2(0, h)) - of.direction(at - glm::dvec2(0, h)));
                        const double cell = glm::length(glm::cross(x, y)) / (4.0 * h * h * n * n);
                        sum += cell * d;
                        area += cell;
                    }
                EXPECT_NEAR(area, of.solid_angle(texel), 2e-3 * area) << info.name << column << "," << row;
                EXPECT_LT(glm::length(sum - of.direction_integral(texel)), 2e-3 * area) << info.name;
            }
    }
}

TEST(EnvironmentLayout, PointsComeBack) {
    for (const EnvironmentLayoutInfo& info : environment_layouts()) {
        const EnvironmentGrid of = grid(info.layout, 6);
        for (int row = 0; row < of.height(); ++row)
            for (int column = 0; column < of.width(); ++column) {
                if (!of.covers({column, row})) continue;
                for (const double x : {0.01, 0.3, 0.99})
                    for (const double y : {0.02, 0.6, 0.98}) {
                        const glm::dvec2 point(column + x, row + y);
                        const glm::dvec2 back = of.locate(2.5 * of.direction(point));
                        EXPECT_NEAR(back.x, point.x, 1e-12) << info.name;
                        EXPECT_NEAR(back.y, point.y, 1e-12) << info.name;
                    }
            }
    }
}

TEST(EnvironmentLayout, DirectionsAreWhereTheyAreSaidToBe) {
    const glm::dvec3 up{0, 0, 1};
    const glm::dvec3 north{0, 1, 0};
    const glm::dvec3 east{1, 0, 0};
    const auto at = [](EnvironmentLayout layout, double x, double y) {
        const EnvironmentGrid of = grid(layout, 100);
        return of.direction({x * of.width(), y * of.height()});
    };
    const auto same = [](const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b) < 1e-12; };
    using enum EnvironmentLayout;
    EXPECT_TRUE(same(at(latlong, 0.5, 0.5), north));
    EXPECT_TRUE(same(at(latlong, 0.75, 0.5), east));
    EXPECT_TRUE(same(at(latlong, 0.3, 0.0), up));
    EXPECT_TRUE(same(at(cube_cross, 3 / 8.0, 1 / 6.0), up));
    EXPECT_TRUE(same(at(cube_cross, 1 / 8.0, 0.5), -east));
    EXPECT_TRUE(same(at(cube_cross, 3 / 8.0, 0.5), north));
    EXPECT_TRUE(same(at(cube_cross, 5 / 8.0, 0.5), east));
    EXPECT_TRUE(same(at(cube_cross, 7 / 8.0, 0.5), -north));
    EXPECT_TRUE(same(at(cube_cross, 3 / 8.0, 5 / 6.0), -up));
    EXPECT_TRUE(same(at(cube_cross_vertical, 0.5, 7 / 8.0), -north));
    const glm::dvec3 faces[] = {east, -east, up, -up, -north, north};
    for (int i = 0; i < 6; ++i)
        EXPECT_TRUE(same(at(cube_strip, (i + 0.5) / 6.0, 0.5), faces[i]));
    EXPECT_TRUE(same(at(octahedral, 0.5, 0.5), up));
    EXPECT_TRUE(same(at(octahedral, 0.5, 1e-15), north));
    EXPECT_TRUE(same(at(octahedral, 1 - 1e-15, 0.5), east));
    EXPECT_TRUE(same(at(octahedral, 1e-15, 1e-15), -up));
    // Columns run to the right and rows down as seen from inside; only the strip is mirrored.
    for (const EnvironmentLayoutInfo& info : environment_layouts()) {
        const EnvironmentGrid of = grid(info.layout, 64);
        for (int row = 3; row < of.height(); row += 20)
            for (int column = 3; column < of.width(); column += 20) {
                if (!of.covers({column, row})) continue;
                const glm::dvec2 point(column + 0.5, row + 0.5);
                const glm::dvec3 right = of.direction(point + glm::dvec2(0.1, 0)) - of.direction(point);
                const glm::dvec3 down = of.direction(point + glm::dvec2(0, 0.1)) - of.direction(point);
                const double turn = glm::dot(glm::cross(right, down), of.direction(point));
                if (info.layout == cube_strip)
                    EXPECT_LT(turn, 0.0);
                else if (info.layout == octahedral)
                    EXPECT_LT(turn, 0.0); // a map of the sky with east to the right is seen from outside
                else
                    EXPECT_GT(turn, 0.0) << info.name;
            }
    }
}

// Neighbours are next to each other on the sphere, and each is the other's neighbour but at the corners of a cube.
TEST(EnvironmentLayout, NeighborsTouch) {
    for (const EnvironmentLayoutInfo& info : environment_layouts()) {
        const EnvironmentGrid of = grid(info.layout, 16);
        const auto middle = [&](TexelIndex t) { return of.direction({t.column + 0.5, t.row + 0.5}); };
        const double size = info.layout == EnvironmentLayout::octahedral ? 0.4 : 0.25;
        for (int row = 0; row < of.height(); ++row)
            for (int column = 0; column < of.width(); ++column) {
                const TexelIndex texel{column, row};
                if (!of.covers(texel)) continue;
                for (const auto& [across, down] :
                     {std::pair{1, 0}, std::pair{-1, 0}, std::pair{0, 1}, std::pair{0, -1}}) {
                    const TexelIndex next = of.neighbor(texel, across, down);
                    EXPECT_TRUE(of.covers(next));
                    EXPECT_NE(next, texel);
                    EXPECT_LT(glm::length(middle(next) - middle(texel)), size) << info.name << column << "," << row;
                }
            }
    }
}

TEST(EnvironmentLayout, SizesThatItDoesNotHave) {
    using enum EnvironmentLayout;
    EXPECT_FALSE(EnvironmentGrid::create(latlong, 100, 51));
    EXPECT_FALSE(EnvironmentGrid::create(latlong, 2, 1));
    EXPECT_FALSE(EnvironmentGrid::create(latlong, 0, 0));
    EXPECT_FALSE(EnvironmentGrid::create(latlong, -4, -2));
    EXPECT_FALSE(EnvironmentGrid::create(cube_cross, 128, 128));
    EXPECT_FALSE(EnvironmentGrid::create(cube_cross, 130, 96));
    EXPECT_FALSE(EnvironmentGrid::create(octahedral, 33, 33));
    EXPECT_EQ(environment_layout_of(200, 100).value(), latlong);
    EXPECT_EQ(environment_layout_of(400, 300).value(), cube_cross);
    EXPECT_EQ(environment_layout_of(300, 400).value(), cube_cross_vertical);
    EXPECT_EQ(environment_layout_of(600, 100).value(), cube_strip);
    EXPECT_EQ(environment_layout_of(64, 64).value(), octahedral);
    EXPECT_EQ(environment_layout_of(201, 100).error().failure, Failure::malformed);
    for (const EnvironmentLayoutInfo& info : environment_layouts())
        EXPECT_EQ(parse_environment_layout(info.name).value(), info.layout);
    EXPECT_FALSE(parse_environment_layout("cube"));
}

} // namespace
} // namespace gonio
