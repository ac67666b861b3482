// The maps of the charts, and the flux of texels near their edges against closed forms, sums over points and
// themselves.
#include <gonio/bake/bake.hpp>
#include <gonio/bake/latlong.hpp>
#include <gonio/bake/texel_flux.hpp>
#include <gonio/web/integrate.hpp>

#include "../scaled.hpp"
#include "../web/webs.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace gonio {
namespace {

using std::numbers::pi;
using test::random_web;
using test::steps;

// Webs of every goniometer, with planes that close, mirror or leave gaps, and with γ that starts late.
std::vector<Web> some_webs() {
    std::vector<Web> webs;
    webs.push_back(random_web(Symmetry::axial, {0}, {0, 3, 7.5, 40, 90}, 1));
    webs.push_back(random_web(Symmetry::quadrant, {0, 11, 45, 90}, steps(0, 90, 19), 2));
    webs.push_back(random_web(Symmetry::bilateral_0_180, steps(0, 180, 13), steps(0, 180, 37), 3));
    webs.push_back(random_web(Symmetry::bilateral_90_270, steps(90, 270, 13), steps(30, 150, 25), 4));
    webs.push_back(random_web(Symmetry::none, steps(0, 360, 25), steps(90, 180, 19), 5));
    webs.push_back(random_web(Symmetry::none, {20, 50, 170}, {0, 60, 120}, 6));
    std::mt19937 random(7);
    for (const Photometry type : {Photometry::a, Photometry::b})
        for (const Symmetry stored : {Symmetry::none, Symmetry::quadrant}) {
            const bool whole = stored == Symmetry::none;
            const std::vector<double> h = whole ? steps(-90, 90, 13) : steps(0, 90, 7);
            const std::vector<double> v = whole ? steps(-60, 75, 10) : steps(0, 80, 5);
            std::vector<double> candela(h.size() * v.size());
            for (double& cd : candela)
                cd = static_cast<double>(random() % 1000);
            webs.push_back(*Web::create(type, stored, h, v, candela));
        }
    return webs;
}

struct Size {
    Layout layout;
    int width;
    int height;
};

constexpr Size whole_sphere[] = {
    {Layout::latlong, 1, 1},
    {Layout::latlong, 9, 5},
    {Layout::v180, 7, 1},
    {Layout::v180, 9, 6},
    {Layout::octahedral, 1, 1},
    {Layout::octahedral, 2, 2},
    {Layout::octahedral, 7, 7},
    {Layout::octahedral, 32, 32},
    {Layout::cube_strip, 6, 1},
    {Layout::cube_strip, 60, 10},
    {Layout::cube_cross, 28, 21},
    {Layout::panorama, 1, 1},
    {Layout::panorama, 4, 2},
    {Layout::panorama, 33, 17},
    {Layout::panorama, 64, 32},
    {Layout::octahedral_equal_area, 1, 1},
    {Layout::octahedral_equal_area, 5, 5},
    {Layout::octahedral_equal_area, 32, 32},
};

std::string name(const Size& size) {
    return std::string(info_of(size.layout).name) + ' ' + std::to_string(size.width) + 'x' +
           std::to_string(size.height);
}

TEST(Charts, FindWhatTheyMap) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (const Size& size : {Size{Layout::latlong, 8, 4},
                             {Layout::v180, 8, 1},
                             {Layout::octahedral, 8, 8},
                             {Layout::octahedral_equal_area, 8, 8},
                             {Layout::cube_strip, 12, 2},
                             {Layout::cube_cross, 8, 6},
                             {Layout::gnomonic, 8, 8},
                             {Layout::panorama, 8, 4}}) {
        const std::vector<PlacedChart> charts = charts_of(size.layout, size.width, size.height, {}).value();
        for (const PlacedChart& placed : charts)
            for (int i = 0; i < 500; ++i) {
                const double s = unit(random);
                const double t = unit(random);
                const ChartPoint point = placed.chart->at(s, t);
                const std::optional<glm::dvec2> found = placed.chart->locate(1.7 * point.direction);
                ASSERT_TRUE(found) << name(size);
                EXPECT_NEAR(found->x, s, 1e-12) << name(size);
                EXPECT_NEAR(found->y, t, 1e-12) << name(size);
                // The derivatives against finite differences.
                const double step = 1e-6;
                const glm::dvec3 along_s =
                    (placed.chart->at(s + step, t).direction - placed.chart->at(s - step, t).direction) / (2.0 * step);
                const glm::dvec3 along_t =
                    (placed.chart->at(s, t + step).direction - placed.chart->at(s, t - step).direction) / (2.0 * step);
                std::vector<double> folds;
                placed.chart->folds(true, t, s - step, s + step, folds);
                placed.chart->folds(false, s, t - step, t + step, folds);
                if (!folds.empty()) continue;
                EXPECT_NEAR(glm::distance(along_s, point.along_s), 0.0, 1e-6) << name(size) << s << ' ' << t;
                EXPECT_NEAR(glm::distance(along_t, point.along_t), 0.0, 1e-6) << name(size) << s << ' ' << t;
            }
    }
}

TEST(Charts, FacesLieWhereOpenGlLooks) {
    const std::vector<PlacedChart> faces = charts_of(Layout::cube_strip, 6, 1, {}).value();
    const glm::dvec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    // The specification's table: the direction in which s grows, and the direction in which t grows.
    const glm::dvec3 towards_s[] = {{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {-1, 0, 0}};
    const glm::dvec3 towards_t[] = {{0, -1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0, -1, 0}, {0, -1, 0}};
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(faces[i].x, static_cast<int>(i));
        const ChartPoint point = faces[i].chart->at(0.5, 0.5);
        EXPECT_EQ(point.direction, axes[i]);
        EXPECT_EQ(point.along_s, 2.0 * towards_s[i]);
        EXPECT_EQ(point.along_t, 2.0 * towards_t[i]);
    }
}

TEST(Charts, HoldTheFluxAtEverySize) {
    for (const Web& web : some_webs())
        for (const Size& size : whole_sphere) {
            BakeOptions options;
            options.layout = size.layout;
            options.width = size.width;
            options.height = size.height;
            const Texture texture = bake_texture(web, options).value();
            // Storing floats rounds each texel by 6e-8.
            EXPECT_NEAR(texture.texture_flux.value, flux(web).value, 1e-7 * flux(web).value)
                << name(size) << " type " << static_cast<int>(web.photometry()) << to_text(web.stored_symmetry());
            EXPECT_NEAR(texture.solid_angle.value, 4.0 * pi, 1e-11) << name(size);
        }
}

// Each texel equals the four quarter texels of a texture of 2N, around poles, folds and gaps as elsewhere.
TEST(Charts, TexelsSplit) {
    for (const Web& web : some_webs()) {
        const Meridians meridians(web);
        for (const Size& size : {Size{Layout::octahedral, 6, 6},
                                 {Layout::octahedral, 7, 7},
                                 {Layout::octahedral_equal_area, 9, 9},
                                 {Layout::cube_strip, 30, 5},
                                 {Layout::panorama, 12, 7},
                                 {Layout::latlong, 7, 5},
                                 {Layout::gnomonic, 9, 9}}) {
            const std::vector<PlacedChart> charts = charts_of(size.layout, size.width, size.height, {}).value();
            for (const PlacedChart& placed : charts) {
                const auto w = static_cast<std::size_t>(placed.width);
                const TexelFlux coarse(meridians, *placed.chart, placed.width, placed.height);
                const TexelFlux fine(meridians, *placed.chart, 2 * placed.width, 2 * placed.height);
                for (int j = 0; j < placed.height; ++j) {
                    std::vector<double> lumens(w), sr(w), upper(2 * w), lower(2 * w), upper_sr(2 * w), lower_sr(2 * w);
                    coarse.rows(j, 1, {}, false, lumens, sr);
                    fine.rows(2 * j, 1, {}, false, upper, upper_sr);
                    fine.rows(2 * j + 1, 1, {}, false, lower, lower_sr);
                    for (std::size_t i = 0; i < w; ++i) {
                        EXPECT_NEAR(lumens[i], upper[2 * i] + upper[2 * i + 1] + lower[2 * i] + lower[2 * i + 1],
                                    1000 * 1e-11)
                            << name(size) << ' ' << i << ' ' << j;
                        EXPECT_NEAR(
                            sr[i], upper_sr[2 * i] + upper_sr[2 * i + 1] + lower_sr[2 * i] + lower_sr[2 * i + 1], 1e-11)
                            << name(size) << ' ' << i << ' ' << j;
                    }
                }
            }
        }
    }
}

// Each texel against a sum over points; the two share only the map.
TEST(Charts, TexelsAreMeansOverTheirSolidAngle) {
    if (test::is_sanitized) GTEST_SKIP() << "compares numbers of texels, which the other tests compute too";
    constexpr int per_texel = 240;
    for (const Web& web : some_webs()) {
        const Meridians meridians(web);
        for (const Size& size : {Size{Layout::octahedral, 4, 4},
                                 {Layout::octahedral, 3, 3},
                                 {Layout::octahedral_equal_area, 3, 3},
                                 {Layout::cube_strip, 6, 1},
                                 {Layout::panorama, 5, 3},
                                 {Layout::gnomonic, 3, 3}}) {
            const std::vector<PlacedChart> charts = charts_of(size.layout, size.width, size.height, {}).value();
            for (const PlacedChart& placed : charts) {
                const auto w = static_cast<std::size_t>(placed.width);
                const TexelFlux flux(meridians, *placed.chart, placed.width, placed.height);
                for (int j = 0; j < placed.height; ++j) {
                    std::vector<double> lumens(w), sr(w);
                    flux.rows(j, 1, {}, false, lumens, sr);
                    for (std::size_t i = 0; i < w; ++i) {
                        double sum = 0.0;
                        double measure = 0.0;
                        for (int a = 0; a < per_texel; ++a)
                            for (int b = 0; b < per_texel; ++b) {
                                const double s = (static_cast<double>(i) + (a + 0.5) / per_texel) / placed.width;
                                const double t = (j + (b + 0.5) / per_texel) / placed.height;
                                const ChartPoint p = placed.chart->at(s, t);
                                const double area = std::abs(glm::dot(p.direction, glm::cross(p.along_s, p.along_t))) /
                                                    std::pow(glm::length(p.direction), 3) / per_texel / per_texel /
                                                    placed.width / placed.height;
                                sum += area * web.candela(p.direction);
                                measure += area;
                            }
                        EXPECT_NEAR(sr[i], measure, 2e-4 * sr[i]) << name(size) << ' ' << i << ' ' << j;
                        // The web ends where its table ends: the points locate that edge to 1/240 of a texel.
                        EXPECT_NEAR(lumens[i] / sr[i], sum / measure, 1000 * 2e-3)
                            << name(size) << ' ' << i << ' ' << j;
                    }
                }
            }
        }
    }
}

// The same texels by the closed form.
TEST(Charts, LatlongIsTheClosedForm) {
    for (const Web& web : some_webs()) {
        if (web.photometry() != Photometry::c) continue;
        constexpr int width = 26;
        constexpr int height = 13;
        const Meridians meridians(web);
        const std::vector<PlacedChart> charts = charts_of(Layout::latlong, width, height, {}).value();
        const TexelFlux around(meridians, *charts[0].chart, width, height);
        const LatlongMeans means(web, width);
        for (int j = 0; j < height; ++j) {
            std::vector<double> lumens(width), sr(width), mean(width);
            around.rows(j, 1, {}, false, lumens, sr);
            means.row(180.0 * j / height, 180.0 * (j + 1) / height, mean);
            for (std::size_t i = 0; i < width; ++i)
                EXPECT_NEAR(lumens[i] / sr[i], mean[i], 1000 * 2e-12) << i << ' ' << j;
        }
    }
}

TEST(Charts, EqualAreaMeansEqual) {
    BakeOptions options;
    options.layout = Layout::octahedral_equal_area;
    const Web web = random_web(Symmetry::axial, {0}, {0, 180}, 1);
    const Meridians meridians(web);
    const std::vector<PlacedChart> charts = charts_of(options.layout, 33, 33, {}).value();
    const TexelFlux flux(meridians, *charts[0].chart, 33, 33);
    std::vector<double> lumens(33), sr(33);
    for (int j = 0; j < 33; ++j) {
        flux.rows(j, 1, {}, false, lumens, sr);
        for (const double texel_sr : sr)
            EXPECT_NEAR(texel_sr, 4.0 * pi / (33 * 33), 1e-13);
    }
}

TEST(Charts, ACookieHoldsItsPyramid) {
    const Web even = *Web::create(Symmetry::axial, {0}, {0, 180}, {100, 100});
    BakeOptions options;
    options.layout = Layout::gnomonic;
    options.width = options.height = 34;
    options.chart.cone = degrees(70);
    options.chart.border = 1;
    const Texture texture = bake_texture(even, options).value();
    const double half = std::sin(35 * pi / 180);
    EXPECT_NEAR(texture.solid_angle.value, 4.0 * std::asin(half * half), 1e-12);
    EXPECT_NEAR(texture.texture_flux.value, 100.0 * texture.solid_angle.value, 1e-5);
    for (int i = 0; i < 34; ++i)
        for (const auto& [x, y] : {std::pair{i, 0}, {i, 33}, {0, i}, {33, i}})
            EXPECT_EQ(*texture.image.at(x, y), 0.0F);
    EXPECT_FLOAT_EQ(*texture.image.at(1, 1), 100.0F);
}

TEST(Charts, ThreadsChangeNothingParallel) {
    const Web web = some_webs()[3];
    for (const Layout layout : {Layout::octahedral, Layout::cube_cross, Layout::panorama}) {
        BakeOptions options;
        options.layout = layout;
        options.width = layout == Layout::cube_cross ? 32 : 24;
        options.height = 24;
        if (layout == Layout::panorama) options.height = 12;
        options.threads = 1;
        const Texture one = bake_texture(web, options).value();
        options.threads = 5;
        const Texture five = bake_texture(web, options).value();
        EXPECT_EQ(one.image.pixels, five.image.pixels);
        EXPECT_EQ(one.texture_flux, five.texture_flux);
    }
}

TEST(TexelTypes, WhatAHalfCannotHoldIsRefused) {
    const Web web = *Web::create(Symmetry::axial, {0.0}, {0.0, 180.0}, {70000.0, 70000.0});
    for (const Layout layout : {Layout::latlong, Layout::octahedral}) {
        BakeOptions options;
        options.layout = layout;
        options.width = options.height = 16;
        options.texel_type = TexelType::half;
        const auto refused = bake_texture(web, options);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().failure, Failure::unsupported);
        EXPECT_EQ(refused.error().diagnostics.back().message,
                  "texels of up to 70000 do not fit 16-bit floats, which end at 65504");
        options.normalization = Normalization::peak;
        EXPECT_TRUE(bake_texture(web, options));
        options.normalization = Normalization::none;
        options.texel_type = TexelType::float32;
        EXPECT_TRUE(bake_texture(web, options));
    }
}

TEST(TexelTypes, RoundToWhatTheyKeep) {
    EXPECT_EQ(as_stored(TexelType::half, 1.0), 1.0);
    EXPECT_EQ(as_stored(TexelType::half, 2049.0), 2048.0); // ties to even
    EXPECT_EQ(as_stored(TexelType::half, 2051.0), 2052.0);
    EXPECT_EQ(as_stored(TexelType::half, 65504.0), 65504.0);
    EXPECT_EQ(as_stored(TexelType::half, 65519.9), 65504.0);
    EXPECT_TRUE(std::isinf(as_stored(TexelType::half, 65520.0)));
    EXPECT_EQ(as_stored(TexelType::half, 0x1p-24), 0x1p-24);
    EXPECT_EQ(as_stored(TexelType::half, 0x1.8p-24), 0x1p-23);
    EXPECT_EQ(as_stored(TexelType::half, 0x1p-26), 0.0);
    EXPECT_EQ(as_stored(TexelType::uint8, 0.5), 128.0 / 255.0);
    EXPECT_EQ(as_stored(TexelType::uint16, 1.5), 1.0);
    EXPECT_EQ(as_stored(TexelType::float32, 0.1), static_cast<double>(0.1F));
}

// A quantisation step of n makes errors of at most half a step, and the flux is that of the stored values.
TEST(TexelTypes, SayWhatTheyLose) {
    const Web web = some_webs()[1];
    for (const auto& [type, step] : {std::pair{TexelType::uint8, 1.0 / 255},
                                     {TexelType::uint16, 1.0 / 65535},
                                     {TexelType::half, 0x1p-11},
                                     {TexelType::float32, 0x1p-24}}) {
        BakeOptions options;
        options.width = 64;
        options.height = 32;
        options.normalization = Normalization::peak;
        options.texel_type = type;
        const Texture texture = bake_texture(web, options).value();
        EXPECT_LE(texture.quantization_error.value, 0.5000001 * step * texture.peak.value);
        EXPECT_GT(texture.quantization_error.value, 0.2 * step * texture.peak.value);
        EXPECT_NEAR(texture.texture_flux.value, flux(web).value, 0.5 * step * texture.peak.value * 4 * pi);
    }
}

TEST(Charts, RefuseSizesThatTheyCannotHave) {
    for (const Size& size : {Size{Layout::octahedral, 8, 4},
                             {Layout::cube_strip, 12, 3},
                             {Layout::cube_cross, 8, 8},
                             {Layout::gnomonic, 3, 4},
                             {Layout::octahedral, 0, 0}}) {
        BakeOptions options;
        options.layout = size.layout;
        options.width = size.width;
        options.height = size.height;
        EXPECT_FALSE(bake_texture(some_webs()[0], options)) << name(size);
    }
    BakeOptions options;
    options.layout = Layout::gnomonic;
    options.width = options.height = 8;
    options.chart.cone = degrees(180);
    EXPECT_FALSE(bake_texture(some_webs()[0], options));
    options.chart.cone = degrees(60);
    options.chart.border = 4;
    EXPECT_FALSE(bake_texture(some_webs()[0], options));
}

} // namespace
} // namespace gonio
