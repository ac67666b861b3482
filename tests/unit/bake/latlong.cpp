#include <gonio/bake/bake.hpp>
#include <gonio/web/integrate.hpp>

#include "../web/webs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gonio {
namespace {

using test::random_web;
using test::steps;

Web web_of(Symmetry stored) {
    switch (stored) {
    case Symmetry::axial:
        return random_web(stored, {0}, {0, 3, 7.5, 40, 90}, 1);
    case Symmetry::quadrant:
        return random_web(stored, {0, 11, 45, 90}, steps(0, 90, 19), 2);
    case Symmetry::bilateral_0_180:
        return random_web(stored, steps(0, 180, 13), steps(0, 180, 37), 3);
    case Symmetry::bilateral_90_270:
        return random_web(stored, steps(90, 270, 13), steps(30, 150, 25), 4);
    case Symmetry::none:
        break;
    }
    return random_web(Symmetry::none, steps(0, 360, 25), steps(90, 180, 19), 5);
}

constexpr Symmetry all_symmetries[] = {Symmetry::axial, Symmetry::quadrant, Symmetry::bilateral_0_180,
                                       Symmetry::bilateral_90_270, Symmetry::none};

// Exact means hold the flux at every size: 1×1 as well as 512×256. Storing floats rounds each texel by 6e-8, and over
// many texels these errors average out.
TEST(BakeLatlong, HoldsTheFluxAtEverySize) {
    for (const Symmetry stored : all_symmetries) {
        const Web web = web_of(stored);
        for (const auto& [width, height] : {std::pair{1, 1}, {1, 7}, {3, 2}, {16, 8}, {100, 37}, {512, 256}}) {
            BakeOptions options;
            options.width = width;
            options.height = height;
            const Texture texture = bake_texture(web, options).value();
            EXPECT_NEAR(texture.texture_flux.value, flux(web).value, 1e-7 * flux(web).value)
                << to_text(stored) << ' ' << width << 'x' << height;
        }
    }
}

// Each texel against the midpoint rule over 48 × 48 points of its area, weighted with sinγ.
TEST(BakeLatlong, TexelsAreMeansOverTheirSolidAngle) {
    for (const Symmetry stored : all_symmetries) {
        const Web web = web_of(stored);
        BakeOptions options;
        options.width = 20;
        options.height = 11;
        const Texture texture = bake_texture(web, options).value();
        for (int j = 0; j < 11; ++j)
            for (int i = 0; i < 20; ++i) {
                double sum = 0.0;
                double measure = 0.0;
                const int n = 48;
                for (int y = 0; y < n; ++y) {
                    const double gamma = (j + (y + 0.5) / n) * 180.0 / 11;
                    const double weight = std::sin(gamma * std::numbers::pi / 180.0);
                    for (int x = 0; x < n; ++x)
                        sum += weight * web.candela((i + (x + 0.5) / n) * 360.0 / 20, gamma);
                    measure += weight * n;
                }
                EXPECT_NEAR(*texture.image.at(i, j), sum / measure, 4.0) << to_text(stored) << i << ',' << j;
            }
    }
}

TEST(BakeLatlong, ThreadsChangeNothing) {
    const Web web = web_of(Symmetry::none);
    BakeOptions options;
    options.threads = 1;
    const Texture one = bake_texture(web, options).value();
    options.threads = 5;
    const Texture five = bake_texture(web, options).value();
    EXPECT_EQ(one.image.pixels, five.image.pixels);
    EXPECT_EQ(one.texture_flux, five.texture_flux);
    EXPECT_EQ(one.max_error, five.max_error);
}

TEST(BakeLatlong, ScalesAndTurnsWithTheWeb) {
    const Web web = web_of(Symmetry::none);
    BakeOptions options;
    options.width = 24;
    options.height = 12;
    const Texture plain = bake_texture(web, options).value();
    const Texture twice = bake_texture(web.scaled(2.0), options).value();
    for (std::size_t i = 0; i < plain.image.pixels.size(); ++i)
        EXPECT_EQ(twice.image.pixels[i], 2.0F * plain.image.pixels[i]);
    // The next plane is the next column: 24 planes, 24 columns.
    std::vector<double> candela;
    for (int p = 0; p <= 24; ++p)
        for (const double cd : web.column(static_cast<std::size_t>((p + 1) % 24)))
            candela.push_back(cd);
    std::vector<double> original;
    for (int p = 0; p <= 24; ++p)
        for (const double cd : web.column(static_cast<std::size_t>(p % 24)))
            original.push_back(cd);
    const std::vector<double> gammas(web.gammas_deg().begin(), web.gammas_deg().end());
    const Web closed = *Web::create(Symmetry::none, steps(0, 360, 25), gammas, original);
    const Web turned = *Web::create(Symmetry::none, steps(0, 360, 25), gammas, candela);
    const Texture a = bake_texture(closed, options).value();
    const Texture b = bake_texture(turned, options).value();
    for (int j = 0; j < 12; ++j)
        for (int i = 0; i < 24; ++i)
            EXPECT_NEAR(*b.image.at(i, j), *a.image.at((i + 1) % 24, j), 1e-4);
}

TEST(BakeLatlong, NormalizationsMeanWhatTheySay) {
    const Web web = web_of(Symmetry::quadrant);
    for (const Normalization how : {Normalization::peak, Normalization::mean, Normalization::flux}) {
        BakeOptions options;
        options.width = 64;
        options.height = 32;
        options.normalization = how;
        const Texture texture = bake_texture(web, options).value();
        EXPECT_NEAR(texture.texture_flux.value, flux(web).value, 1e-7 * flux(web).value);
        options.normalization = Normalization::none;
        const Texture plain = bake_texture(web, options).value();
        EXPECT_NEAR(texture.image.pixels[70] * texture.cd_per_unit, plain.image.pixels[70], 1e-4);
    }
}

TEST(BakeLatlong, RefusesSizesAndDarkness) {
    const Web web = web_of(Symmetry::axial);
    for (const auto& [width, height] : {std::pair{0, 1}, {1, 0}, {-5, 5}, {40000, 1}, {32768, 32768}}) {
        BakeOptions options;
        options.width = width;
        options.height = height;
        EXPECT_FALSE(bake_texture(web, options));
    }
    const Web dark = *Web::create(Symmetry::axial, {0}, {0, 90}, {0, 0});
    BakeOptions options;
    EXPECT_TRUE(bake_texture(dark, options));
    options.normalization = Normalization::peak;
    EXPECT_FALSE(bake_texture(dark, options));
}

TEST(BakeLatlong, NegativeIntensitiesAreStoredAsNothing) {
    const Web web = *Web::create(Symmetry::axial, {0}, {0, 90}, {-5, -5});
    const Texture texture = bake_texture(web, {}).value();
    for (const float texel : texture.image.pixels)
        EXPECT_EQ(texel, 0.0F);
    EXPECT_NEAR(texture.max_error.value, 5.0, 1e-12);
}

} // namespace
} // namespace gonio
