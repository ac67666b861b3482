// Textures for engines, evaluated by the formulas that the engines use, and the smallest texture within an error.
#include <gonio/bake/engine.hpp>
#include <gonio/web/integrate.hpp>

#include "../web/webs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace gonio {
namespace {

using std::numbers::pi;
using test::random_web;
using test::steps;

// Smooth and without any symmetry, so that every rotation and mirror shows.
Web smooth_web() {
    const std::vector<double> planes = steps(0, 360, 49);
    const std::vector<double> gammas = steps(0, 180, 25);
    std::vector<double> candela;
    for (const double c : planes)
        for (const double gamma : gammas) {
            const double x = std::sin(gamma * pi / 180) * std::cos(c * pi / 180);
            const double y = std::sin(gamma * pi / 180) * std::sin(c * pi / 180);
            const double z = -std::cos(gamma * pi / 180);
            candela.push_back(100 + 50 * x + 25 * y * y + 20 * x * y - 10 * z + 15 * y);
        }
    return *Web::create(Symmetry::none, planes, gammas, candela);
}

// At most 128 texels per side, if the engine allows it.
BakeOptions smaller(BakeOptions options) {
    while (options.sampling == Sampling::mean && options.height > 128) {
        options.width /= 2;
        options.height /= 2;
    }
    return options;
}

Texture baked(const char* engine, const Web& web) {
    return bake_texture(web, smaller(find_engine(engine).value()->bake)).value();
}

// The value of texel (i, j) in candela.
double texel(const Texture& texture, int i, int j) {
    return *texture.image.at(i, j) * texture.cd_per_unit;
}

double mean_over_c(const Web& web, double gamma) {
    double sum = 0.0;
    for (int k = 0; k < 720; ++k)
        sum += web.candela((k + 0.5) * 0.5, gamma) / 720;
    return sum;
}

TEST(Engines, RowsStandAtLeftEdges) {
    const Web web = smooth_web();
    for (const char* name : {"three-r186", "unreal"}) {
        const Texture texture = baked(name, web);
        const double step = 1e-3; // half: 11 bits
        for (const int i : {0, 1, 45, 100, texture.image.width - 1})
            EXPECT_NEAR(texel(texture, i, 0), mean_over_c(web, 180.0 * i / texture.image.width), 200 * step)
                << name << ' ' << i;
    }
}

// three.js since r187: the shader's own positions of gamma and C, from remap() and the insets of half a texel.
TEST(Engines, ThreeLooksUpGammaAndC) {
    const Web web = smooth_web();
    const Texture texture = baked("three", web);
    const int w = texture.image.width;
    const int h = texture.image.height;
    for (const double c : {0.0, 31.0, 90.0, 180.0, 270.0, 359.0})
        for (const double gamma : {0.0, 1.0, 47.0, 90.0, 180.0}) {
            const double tilt = 0.5 / w + gamma / 180.0 * (1.0 - 1.0 / w);
            const double twist = std::fmod(c + 180.0, 360.0) / 360.0 + 0.5 / h;
            const auto i = static_cast<int>(tilt * w);
            const auto j = static_cast<int>(twist * h);
            EXPECT_NEAR(texel(texture, i, j), web.candela(c, gamma), texture.peak.value * 1e-3) << c << ' ' << gamma;
        }
}

// Babylon.js: u = gamma/180° at the centres of texels; each texel holds the mean over its area.
TEST(Engines, BabylonStandsAtMiddles) {
    const Web web = smooth_web();
    const Texture texture = baked("babylon", web);
    for (const int i : {1, 45, 100, texture.image.width - 2})
        EXPECT_NEAR(texel(texture, i, 0), mean_over_c(web, i + 0.5), 1e-3 * texture.peak.value) << i;
}

// From the shaders' text: the half of the double paraboloid for a direction, and the panorama texel copied there.
TEST(Engines, GodotOmniStandsOnItsHead) {
    const Web web = smooth_web();
    const Texture texture = baked("godot-omni", web);
    const int w = texture.image.width;
    const int h = texture.image.height;
    for (const double c : {10.0, 100.0, 190.0, 300.0})
        for (const double gamma : {20.0, 70.0, 110.0, 160.0}) {
            const glm::dvec3 v = direction_of({degrees(c), degrees(gamma)});
            const double turn = v.z >= 0.0 ? std::atan2(-v.x, -v.z) : -std::atan2(v.x, -v.z);
            const double u = turn / (2.0 * pi) - std::floor(turn / (2.0 * pi));
            const auto i = static_cast<int>(u * w);
            const auto j = static_cast<int>(std::acos(-v.y) / pi * h);
            // Half a texel is 0.35°; an 8-bit step is 2 % of the value in dark areas.
            EXPECT_NEAR(texel(texture, i, j), web.candela(c, gamma), 0.02 * texture.peak.value) << c << ' ' << gamma;
        }
}

// Types A and B are integrated over thin rings.
TEST(Engines, RowsOfNativeWebs) {
    const std::vector<double> h = steps(-90, 90, 19);
    const std::vector<double> v = steps(-90, 90, 19);
    const Web b = *Web::create(Photometry::b, Symmetry::none, h, v, std::vector<double>(19 * 19, 70.0));
    const Texture texture = baked("three-r186", b);
    EXPECT_NEAR(texel(texture, 0, 0), 70.0, 0.05); // half
    EXPECT_NEAR(texel(texture, 60, 0), 70.0, 0.05);
    EXPECT_NEAR(texel(texture, 120, 0), 0.0, 1e-4);
}

// pbrt-v4: EqualAreaSquareToSphere with y and z swapped; the image's rows run downwards.
TEST(Engines, PbrtLooksUpWhatItMeans) {
    const Web web = smooth_web();
    const Texture texture = baked("pbrt-v4", web);
    const int n = texture.image.width;
    const int near = 1;
    // Centre: aim. Midpoints of edges: right +X is C0, bottom +Z is C90. Corners: γ = 180°.
    EXPECT_NEAR(texel(texture, n / 2, n / 2), web.candela(0, 0), 2.0);
    EXPECT_NEAR(texel(texture, n - near, n / 2), web.candela(0, 90), 2.0);
    EXPECT_NEAR(texel(texture, n / 2, n - near), web.candela(90, 90), 2.0);
    EXPECT_NEAR(texel(texture, near, n / 2), web.candela(180, 90), 2.0);
    EXPECT_NEAR(texel(texture, n / 2, near), web.candela(270, 90), 2.0);
    EXPECT_NEAR(texel(texture, 0, 0), web.candela(0, 180), 2.0);
}

// Unity: V = atan(r), H = atan2(v, u) − 90°, pixels 1 to N−2 from −tan(cone/2) to tan(cone/2).
TEST(Engines, UnityCookieRunsFromEdgeToEdge) {
    const Web web = smooth_web();
    const Texture texture = baked("unity-spot", web);
    const int n = texture.image.width;
    const double limit = std::tan(45.0 * pi / 180.0);
    for (const int i : {1, 30, 64, n - 2})
        for (const int j : {1, 50, n - 2}) {
            const double u = limit * (2.0 * (i - 1) / (n - 3) - 1.0);
            const double v = limit * (1.0 - 2.0 * (j - 1) / (n - 3));
            double h = std::atan2(v, u) * 180.0 / pi - 90.0;
            if (h < 0.0) h += 360.0;
            EXPECT_NEAR(texel(texture, i, j), web.candela(h, std::atan(std::hypot(u, v)) * 180.0 / pi),
                        texture.peak.value / 254.0)
                << i << ' ' << j;
        }
    for (int i = 0; i < n; ++i)
        EXPECT_EQ(*texture.image.at(i, 0), 0.0F);
}

// Centre V = 0, up H = 0, left H = 90.
TEST(Engines, UnityPointLooksAlongTheAim) {
    const Web web = smooth_web();
    const Texture texture = baked("unity-point", web);
    const int w = texture.image.width;
    const int h = texture.image.height;
    EXPECT_NEAR(texel(texture, w / 2, h / 2), web.candela(0, 0), 1.0);
    EXPECT_NEAR(texel(texture, 0, h / 2), web.candela(0, 180), 1.0);
    EXPECT_NEAR(texel(texture, w / 2, 0), web.candela(0, 90), 1.0);
    EXPECT_NEAR(texel(texture, w / 4, h / 2), web.candela(90, 90), 1.0);
    EXPECT_NEAR(texel(texture, 3 * w / 4, h / 2), web.candela(270, 90), 1.0);
}

TEST(Engines, UnrealRunsAcrossGammaAndDownC) {
    const Web web = smooth_web();
    const Texture texture = baked("unreal-2d", web);
    const int n = texture.image.width;
    for (const int i : {0, 30, 100, n - 1})
        for (const int j : {0, 50, n - 1})
            EXPECT_NEAR(texel(texture, i, j), web.candela((j + 0.5) / n * 360, (i + 0.5) / n * 180), 0.5);
}

TEST(Engines, NablaStandsOnCorners) {
    const Web web = smooth_web();
    const Texture texture = baked("nabla", web);
    EXPECT_NEAR(texel(texture, 128, 128), web.candela(0, 0), 0.01);
    EXPECT_NEAR(texel(texture, 256, 128), web.candela(0, 90), 0.01);
    EXPECT_NEAR(texel(texture, 128, 0), web.candela(90, 90), 0.01);
    EXPECT_NEAR(texel(texture, 0, 256), web.candela(0, 180), 0.01);
}

// An encoded file holds steps of the encoding, which are fine in dark areas.
TEST(Engines, GodotEncodes) {
    const Web web = smooth_web();
    const Texture texture = baked("godot-omni", web);
    EXPECT_EQ(texture.transfer, Transfer::srgb);
    EXPECT_LT(texture.quantization_error.value, texture.peak.value * 0.5 / 255 * 2.3);
    for (const float value : texture.image.pixels) {
        const double steps_of = encoded(Transfer::srgb, static_cast<double>(value)) * 255.0;
        ASSERT_NEAR(steps_of, std::nearbyint(steps_of), 1e-4);
    }
    for (const double x : {0.0, 0.001, 0.0031308, 0.2, 1.0})
        EXPECT_NEAR(decoded(Transfer::srgb, encoded(Transfer::srgb, x)), x, 1e-7);
    EXPECT_NEAR(encoded(Transfer::srgb, 0.5), 0.7353569830524495, 1e-12); // IEC 61966-2-1
}

TEST(Engines, MeansHoldTheFlux) {
    const Web web = smooth_web();
    for (const Engine& engine : engines()) {
        if (engine.bake.sampling != Sampling::mean || engine.bake.layout == Layout::gnomonic) continue;
        BakeOptions options = smaller(engine.bake);
        options.texel_type = TexelType::float32;
        options.transfer = Transfer::linear;
        const Texture texture = bake_texture(web, options).value();
        EXPECT_NEAR(texture.texture_flux.value, flux(web).value, 1e-7 * flux(web).value) << engine.name;
    }
}

TEST(AutoSize, IsTheSmallestWithinTheError) {
    const Web web = smooth_web();
    for (const Layout layout :
         {Layout::latlong, Layout::v180, Layout::octahedral, Layout::cube, Layout::cube_cross, Layout::gnomonic}) {
        BakeOptions options;
        options.layout = layout;
        options.chart.border = layout == Layout::gnomonic ? 1 : 0;
        const bool axial_only = layout == Layout::v180;
        const Web of = axial_only ? random_web(Symmetry::axial, {0}, steps(0, 180, 7), 3) : web;
        const Candelas limit(axial_only ? 20.0 : 3.0);
        const Result<Texture> found = bake_smallest(of, options, limit);
        ASSERT_TRUE(found) << info_of(layout).name;
        EXPECT_LE(found->max_error.value, limit.value);
        // A texture one step smaller is not accurate enough.
        const int across = layout == Layout::latlong      ? 2
                           : layout == Layout::cube       ? 6
                           : layout == Layout::cube_cross ? 4
                                                          : 1;
        const int down = layout == Layout::v180 ? 0 : layout == Layout::cube_cross ? 3 : 1;
        options.width = found->image.width - across;
        options.height = found->image.height - down;
        EXPECT_GT(bake_texture(of, options).value().max_error.value, limit.value) << info_of(layout).name;
    }
    // At a jump the error is never less than half of the jump.
    const Web jump = *Web::create(Symmetry::axial, {0}, {0, 60}, {1000, 1000});
    BakeOptions options;
    options.layout = Layout::v180;
    const Result<Texture> never = bake_smallest(jump, options, Candelas(1.0));
    ASSERT_FALSE(never);
    EXPECT_NE(never.error().diagnostics.front().message.find("no size up to 4096x1"), std::string::npos);
}

} // namespace
} // namespace gonio
