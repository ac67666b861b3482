#include <gonio/base/gauss_legendre.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/sky/environment_map.hpp>
#include <gonio/sky/environment_resample.hpp>
#include <gonio/sky/sky_direction.hpp>
#include <gonio/sky/sun_extraction.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

namespace gonio {
namespace {

using std::numbers::pi;
using enum EnvironmentLayout;

EnvironmentGrid grid(EnvironmentLayout layout, int side) {
    return environment_grid(layout, side).value();
}

double luminance(const glm::dvec3& rgb) {
    return glm::dot(rgb, rec709_luminance);
}

template<class Pixel>
EnvironmentMap made(const EnvironmentGrid& of, const Pixel& pixel) {
    Image image(of.width(), of.height(), 3);
    for (int row = 0; row < of.height(); ++row)
        for (int column = 0; column < of.width(); ++column) {
            if (!of.covers({column, row})) continue;
            const glm::dvec3 light = pixel(TexelIndex{column, row});
            for (int c = 0; c < 3; ++c)
                image.at(column, row)[c] = static_cast<float>(light[c]);
        }
    return EnvironmentMap::of_valid(of, std::move(image), 1.0);
}

// A hostile picture: every texel another value over six orders of magnitude, and a sun of one texel.
EnvironmentMap random_map(const EnvironmentGrid& of, bool with_sun = true) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> exponent(-3.0, 3.0);
    return made(of, [&](TexelIndex texel) {
        const glm::dvec3 light(std::pow(10.0, exponent(random)), std::pow(10.0, exponent(random)),
                               std::pow(10.0, exponent(random)));
        const bool sun = with_sun && texel == of.texel_at(direction_of({200.0, 37.0}));
        return sun ? glm::dvec3(1e9, 0.9e9, 0.7e9) : light;
    });
}

TEST(EnvironmentMap, AUniformImageIsAUniformSky) {
    for (const EnvironmentLayoutInfo& info : environment_layouts()) {
        const EnvironmentMap map = made(grid(info.layout, 12), [](TexelIndex) { return glm::dvec3(2, 3, 4); });
        for (const glm::dvec3& normal :
             {glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0), glm::normalize(glm::dvec3(1, 2, -3))})
            EXPECT_LT(glm::length(map.irradiance(normal) - pi * glm::dvec3(2, 3, 4)), 1e-5) << info.name;
        EXPECT_LT(glm::length(map.light() - 4.0 * pi * glm::dvec3(2, 3, 4)), 1e-10) << info.name;
        for (int i = 0; i < 200; ++i)
            EXPECT_LT(glm::length(map.radiance(direction_of({i * 17.0, i * 0.9 - 90.0})) - glm::dvec3(2, 3, 4)), 1e-12);
    }
}

// Bilinear lookup of a smooth function: at a seam, at the poles, at edges and folds it is as near as elsewhere.
TEST(EnvironmentMap, LookupIsContinuous) {
    const glm::dvec3 lobe = direction_of({17.0, 23.0});
    const auto smooth = [&](const glm::dvec3& d) { return 2.0 + glm::dot(d, lobe) + 0.5 * d.x * d.y; };
    for (const EnvironmentLayoutInfo& info : environment_layouts()) {
        const EnvironmentGrid of = grid(info.layout, side_like(latlong, 64, info.layout));
        const EnvironmentMap map = made(of, [&](TexelIndex texel) {
            return glm::dvec3(smooth(of.direction({texel.column + 0.5, texel.row + 0.5})));
        });
        double worst = 0.0;
        double step = 0.0;
        for (int i = 0; i < 20000; ++i) {
            const double z = 1.0 - 2.0 * (i + 0.5) / 20000;
            const double turn = 2.399963229728653 * i;
            const glm::dvec3 d{std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z};
            worst = std::fmax(worst, std::abs(map.radiance(d).x - smooth(d)));
        }
        // Along a circle that crosses every edge, the value does not jump.
        double before = map.radiance(direction_of({0.0, 0.0})).x;
        for (int i = 1; i <= 100000; ++i) {
            const double angle = 2.0 * pi * i / 100000;
            const glm::dvec3 d =
                std::cos(angle) * glm::dvec3(0, 1, 0) + std::sin(angle) * glm::normalize(glm::dvec3(0.4, 0.0, 0.9));
            const double here = map.radiance(d).x;
            step = std::fmax(step, std::abs(here - before));
            before = here;
        }
        // A cube takes the nearest texel beyond its edges; the slope of an octahedral picture jumps at its folds.
        const bool cube = info.layout != latlong && info.layout != octahedral;
        EXPECT_LT(worst, info.layout == latlong ? 4e-3 : 0.03) << info.name;
        EXPECT_LT(step, cube ? 0.02 : 3e-4) << info.name;
    }
}

TEST(EnvironmentMap, IrradianceIsThatOfTexels) {
    const EnvironmentGrid of = grid(latlong, 16);
    const EnvironmentMap map = random_map(of);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.2, 0.9, 0.4));
    // Independent: points in each texel.
    double sum = 0.0;
    constexpr int n = 400;
    for (int row = 0; row < of.height(); ++row)
        for (int column = 0; column < of.width(); ++column) {
            double part = 0.0;
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const double zenith = pi * (row + (j + 0.5) / n) / of.height();
                    const double azimuth = 2.0 * pi * ((column + (i + 0.5) / n) / of.width() - 0.5);
                    const glm::dvec3 d{std::sin(zenith) * std::sin(azimuth), std::sin(zenith) * std::cos(azimuth),
                                       std::cos(zenith)};
                    part += std::fmax(glm::dot(d, normal), 0.0) * std::sin(zenith);
                }
            sum += part * pi / of.height() / n * 2.0 * pi / of.width() / n * luminance(map.texel({column, row}));
        }
    EXPECT_NEAR(luminance(map.irradiance(normal)) / sum, 1.0, 1e-5);
    // The same for any number of threads.
    EXPECT_EQ(map.irradiance(normal, 1), map.irradiance(normal, 3));
    EXPECT_EQ(map.light(1), map.light(5));
}

TEST(EnvironmentMap, BadPixelsAreCountedAndFound) {
    Image image(8, 4, 3);
    std::fill(image.pixels.begin(), image.pixels.end(), 1.0F);
    image.at(5, 1)[1] = std::nanf("");
    image.at(2, 2)[0] = -1.0F;
    image.at(7, 2)[2] = -0.5F;
    image.at(0, 3)[2] = std::numeric_limits<float>::infinity();
    image.at(1, 3)[0] = -0.0F; // is 0
    Diagnostics said;
    const Result<EnvironmentMap> refused = EnvironmentMap::create(latlong, image, 1.0, BadPixels::error, said);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().failure, Failure::malformed);
    EXPECT_EQ(refused.error().diagnostics.back().message,
              "4 pixels cannot be light (1 not a number, 1 infinite, 2 negative), the first in column 5, row 1");
    EXPECT_TRUE(said.empty());
    const Result<EnvironmentMap> black = EnvironmentMap::create(latlong, image, 1.0, BadPixels::black, said);
    ASSERT_TRUE(black);
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(said[0].code, "RES0501");
    EXPECT_EQ(black->texel({5, 1}), glm::dvec3(0.0));
    EXPECT_EQ(black->texel({4, 1}), glm::dvec3(1.0));
    // The corners of a cross do not count.
    Image cross(16, 12, 3);
    cross.at(0, 0)[1] = std::nanf("");
    cross.at(15, 11)[1] = -1.0F;
    said.clear();
    const Result<EnvironmentMap> corners = EnvironmentMap::create(cube_cross, cross, 1.0, BadPixels::error, said);
    ASSERT_TRUE(corners);
    EXPECT_EQ(corners->texel({0, 0}), glm::dvec3(0.0));
    EXPECT_FALSE(EnvironmentMap::create(latlong, Image(8, 5, 3), 1.0, BadPixels::error, said));
    EXPECT_FALSE(EnvironmentMap::create(latlong, Image(8, 4, 1), 1.0, BadPixels::error, said));
}

TEST(EnvironmentMap, ClippedPixelsAreRemarked) {
    const auto codes = [](float value, int count) {
        Image image(64, 32, 3);
        std::fill(image.pixels.begin(), image.pixels.end(), 1.0F);
        std::fill_n(image.pixels.begin(), count, value);
        Diagnostics said;
        EXPECT_TRUE(EnvironmentMap::create(latlong, std::move(image), 1.0, BadPixels::error, said));
        std::string all;
        for (const Diagnostic& one : said)
            all += one.code;
        return all;
    };
    EXPECT_EQ(codes(65504.0F, 3), "RES0502");
    EXPECT_EQ(codes(65503.0F, 3), "");
    EXPECT_EQ(codes(65505.0F, 3), ""); // half floats do not hold it, so they have not cut it off
    EXPECT_EQ(codes(1000.0F, 30), "RES0503");
    EXPECT_EQ(codes(1000.0F, 3), "");
    EXPECT_EQ(codes(2.0F, 300), "");
    EXPECT_EQ(codes(0.0F, 64 * 32 * 3), ""); // black
}

TEST(EnvironmentMap, IsCalibrated) {
    EnvironmentMap map = random_map(grid(latlong, 16));
    ASSERT_TRUE(calibrate(map, {Calibration::Of::illuminance, 500.0, {0, 0, 1}}));
    EXPECT_NEAR(luminance(map.irradiance({0, 0, 1})), 500.0, 1e-9);
    ASSERT_TRUE(calibrate(map, {Calibration::Of::illuminance, 70.0, direction_of({90.0, 0.0})}));
    EXPECT_NEAR(luminance(map.irradiance({1, 0, 0})), 70.0, 1e-10);
    ASSERT_TRUE(calibrate(map, {Calibration::Of::mean_luminance, 30.0}));
    EXPECT_NEAR(luminance(map.light()), 30.0 * 4.0 * pi, 1e-10);
    ASSERT_TRUE(calibrate(map, {Calibration::Of::zenith_luminance, 30.0}));
    EXPECT_NEAR(luminance(map.radiance({0, 0, 1})), 30.0, 1e-12);
    EXPECT_FALSE(calibrate(map, {Calibration::Of::illuminance, 0.0}));
    EXPECT_FALSE(calibrate(map, {Calibration::Of::illuminance, -1.0}));
    EnvironmentMap black = made(grid(latlong, 16), [](TexelIndex) { return glm::dvec3(0.0); });
    for (const auto of :
         {Calibration::Of::illuminance, Calibration::Of::mean_luminance, Calibration::Of::zenith_luminance})
        EXPECT_FALSE(calibrate(black, {of, 500.0}));
}

TEST(EnvironmentResample, KeepsTheEnergy) {
    for (const EnvironmentLayoutInfo& from : environment_layouts()) {
        const EnvironmentMap source = random_map(grid(from.layout, side_like(latlong, 32, from.layout)));
        const glm::dvec3 before = source.light();
        for (const EnvironmentLayoutInfo& to : environment_layouts())
            for (const int side : {6, 22, 48}) {
                const EnvironmentMap result = resampled(source, grid(to.layout, side));
                const glm::dvec3 after = result.light();
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(after[c] / before[c], 1.0, 1e-7) << from.name << " to " << to.name << " " << side;
            }
    }
}

TEST(EnvironmentResample, KeepsUniformImages) {
    for (const EnvironmentLayoutInfo& from : environment_layouts()) {
        const EnvironmentMap source =
            made(grid(from.layout, side_like(latlong, 40, from.layout)), [](TexelIndex) { return glm::dvec3(5.0); });
        for (const EnvironmentLayoutInfo& to : environment_layouts())
            for (const int side : {8, 50}) {
                const EnvironmentGrid of = grid(to.layout, side);
                const EnvironmentMap result = resampled(source, of);
                for (int row = 0; row < of.height(); ++row)
                    for (int column = 0; column < of.width(); ++column)
                        ASSERT_NEAR(result.texel({column, row}).x, of.covers({column, row}) ? 5.0 : 0.0, 5.0 * 5e-6)
                            << from.name << " to " << to.name << " " << side << ": " << column << "," << row;
            }
    }
}

// A picture in its own layout and size is itself; to a multiple of its size each texel becomes equal ones, and back.
TEST(EnvironmentResample, ReturnsThePictureItself) {
    for (const EnvironmentLayoutInfo& info : environment_layouts()) {
        const EnvironmentGrid small = grid(info.layout, 12);
        const EnvironmentMap source = random_map(small, false);
        const EnvironmentMap same = resampled(source, small);
        const EnvironmentMap larger = resampled(source, grid(info.layout, 36));
        const EnvironmentMap back = resampled(larger, small);
        for (int row = 0; row < small.height(); ++row)
            for (int column = 0; column < small.width(); ++column) {
                const glm::dvec3 expected = source.texel({column, row});
                // Chords of other lengths move a parallel by a millionth of a texel of up to 1000.
                const double near = 1e-5 * expected.x + 2e-3;
                ASSERT_NEAR(same.texel({column, row}).x, expected.x, near) << info.name << column << "," << row;
                ASSERT_NEAR(larger.texel({3 * column + 1, 3 * row + 1}).x, expected.x, near) << info.name;
                ASSERT_NEAR(back.texel({column, row}).x, expected.x, 2.0 * near) << info.name;
            }
    }
}

// The illuminance of planes stays, as far as texels do not blur it.
TEST(EnvironmentResample, KeepsTheIlluminance) {
    const Sky sky = resolve_sky(parse_sky_description("cie:12,sun=200/40,horizontal=10klx,ground=0.3").value()).value();
    const EnvironmentMap source = rendered(sky, grid(latlong, 128));
    for (const EnvironmentLayoutInfo& to : environment_layouts()) {
        const EnvironmentMap result = resampled(source, grid(to.layout, side_like(latlong, 128, to.layout)));
        for (const glm::dvec3& normal : {glm::dvec3(0, 0, 1), glm::dvec3(0, -1, 0), glm::dvec3(1, 0, 0)})
            EXPECT_NEAR(luminance(result.irradiance(normal)) / luminance(source.irradiance(normal)), 1.0, 3e-4)
                << to.name;
    }
    EXPECT_EQ(resampled(source, grid(cube_cross, 20), {}, 1).image().pixels,
              resampled(source, grid(cube_cross, 20), {}, 3).image().pixels);
}

// Turned by a quarter, a wall reads what the wall beside it read; the light stays.
TEST(EnvironmentResample, Turns) {
    for (const EnvironmentLayoutInfo& from : environment_layouts()) {
        const EnvironmentMap source = random_map(grid(from.layout, 16), false);
        for (const EnvironmentLayoutInfo& to : environment_layouts()) {
            const EnvironmentMap result = resampled(source, grid(to.layout, 16), degrees(90.0));
            EXPECT_NEAR(luminance(result.light()) / luminance(source.light()), 1.0, 1e-7) << from.name << to.name;
            if (from.layout != to.layout) continue;
            EXPECT_NEAR(luminance(result.irradiance({1, 0, 0})) / luminance(source.irradiance({0, 1, 0})), 1.0, 1e-6);
            EXPECT_NEAR(luminance(result.irradiance({0, -1, 0})) / luminance(source.irradiance({1, 0, 0})), 1.0, 1e-6);
        }
    }
}

// A sky as an image: its texels are the means, and the meter reads the same.
TEST(EnvironmentRendered, IsTheSky) {
    for (const char* text : {"cie:12,sun=200/40,horizontal=10klx,ground=0.2", "cie:15,sun=90/3,zenith=100nt",
                             "cie:overcast,mean=1000nt", "uniform:mean=7nt,color=3000K"}) {
        const Sky sky = resolve_sky(parse_sky_description(text).value()).value();
        for (const EnvironmentLayoutInfo& info : environment_layouts()) {
            const EnvironmentMap map = rendered(sky, grid(info.layout, side_like(latlong, 128, info.layout)));
            const glm::dvec3 all = map.light();
            EXPECT_NEAR(luminance(all) / luminance(sky.light()), 1.0, 1e-6) << text << " " << info.name;
            for (const glm::dvec3& normal :
                 {glm::dvec3(0, 0, 1), direction_of({200.0, 0.0}), direction_of({20.0, 50.0})})
                // Texels blur the steep gradation at the horizon.
                EXPECT_NEAR(luminance(map.irradiance(normal)) / luminance(sky.irradiance(normal)), 1.0, 1e-3)
                    << text << " " << info.name << " " << normal.z;
        }
    }
}

// The blur falls with the square of the texel's size: the meter reads the same to 1e-4 from 512 rows on.
TEST(EnvironmentRendered, ConvergesToTheSky) {
    const Sky sky = resolve_sky(parse_sky_description("cie:15,sun=90/3,zenith=100nt").value()).value();
    const double truth = luminance(sky.irradiance({0, 0, 1}));
    const auto error = [&](int side) {
        return std::abs(luminance(rendered(sky, grid(latlong, side)).irradiance({0, 0, 1})) / truth - 1.0);
    };
    const double coarse = error(128);
    const double fine = error(512);
    EXPECT_LT(fine, coarse / 8.0);
    EXPECT_LT(fine, 1e-4);
}

TEST(EnvironmentGridSize, IsLimited) {
    EXPECT_TRUE(environment_grid(latlong, 4096));
    EXPECT_FALSE(environment_grid(latlong, 8192));
    EXPECT_FALSE(environment_grid(octahedral, 2147483646));
    EXPECT_FALSE(environment_grid(cube_cross, 0));
    EXPECT_FALSE(environment_grid(octahedral, 7));
}

TEST(SunExtraction, KeepsTheIlluminance) {
    const Sky sky = resolve_sky(parse_sky_description("cie:12,sun=200/40,horizontal=15klx,ground=0.2").value()).value();
    const glm::dvec3 sun = direction_of({201.3, 41.7});
    for (const EnvironmentLayoutInfo& info : environment_layouts()) {
        const EnvironmentGrid of = grid(info.layout, side_like(latlong, 256, info.layout));
        const EnvironmentMap plain = rendered(sky, of);
        const EnvironmentMap map = made(of, [&](TexelIndex texel) {
            const double away = glm::length(of.direction({texel.column + 0.5, texel.row + 0.5}) - sun);
            return plain.texel(texel) + 2e6 * std::exp(-std::pow(away / 0.015, 2.0)) * glm::dvec3(1.1, 1.0, 0.7);
        });
        const Result<ExtractedSun> found = extract_sun(map);
        ASSERT_TRUE(found) << info.name;
        EXPECT_LT(glm::length(found->sun.direction - sun), 1e-3);
        EXPECT_NEAR(luminance(found->sun.color), 1.0, 1e-12);
        EXPECT_GT(found->sun.color.x, found->sun.color.z);
        EXPECT_GT(found->texels, 4U);
        // A Gaussian exp(−(r/s)²): π s² times its peak.
        EXPECT_NEAR(found->sun.illuminance.value / (2e6 * luminance({1.1, 1.0, 0.7}) * pi * 0.015 * 0.015), 1.0, 0.01);
        for (const glm::dvec3& normal : {glm::dvec3(0, 0, 1), direction_of({200.0, 0.0}), direction_of({180.0, 30.0}),
                                         direction_of({250.0, -20.0})}) {
            const double before = luminance(map.irradiance(normal));
            const double after = luminance(found->sky.irradiance(normal)) +
                                 found->sun.illuminance.value * glm::dot(normal, found->sun.direction);
            EXPECT_NEAR(after / before, 1.0, 1e-9) << info.name << " " << normal.z;
        }
        // What remains is the sky without a peak: no second sun.
        EXPECT_LT(luminance(found->sky.texel(found->sky.brightest())), 3.0 * luminance(plain.texel(plain.brightest())));
    }
}

// A sun that is put into an image adds its illuminance, and is what is taken out again.
TEST(SunExtraction, ReturnsTheSunThatWasPutIn) {
    const Sky sky =
        resolve_sky(parse_sky_description("daylight:place=52.52/13.405,time=2024-06-21T12:00+02:00").value()).value();
    const SunLight& sun = *sky.sun();
    for (const EnvironmentLayoutInfo& info : environment_layouts())
        for (const int side : {128, 1024}) { // a part of a texel, and a dozen of them
            if (side > 128 && info.layout != latlong) continue;
            const EnvironmentMap plain = rendered(sky, grid(info.layout, side_like(latlong, side, info.layout)));
            const EnvironmentMap map = with_sun(plain, sun);
            const double added = luminance(map.irradiance(sun.direction)) - luminance(plain.irradiance(sun.direction));
            EXPECT_NEAR(added / sun.illuminance.value, 1.0, 1e-3) << info.name << side;
            const Result<ExtractedSun> found = extract_sun(map);
            ASSERT_TRUE(found) << info.name << side;
            EXPECT_NEAR(found->sun.illuminance.value / sun.illuminance.value, 1.0, 2e-3) << info.name << side;
            EXPECT_LT(glm::length(found->sun.direction - sun.direction), 1.5 * pi / side) << info.name << side;
            EXPECT_NEAR(luminance(found->sky.irradiance({0, 0, 1})) / luminance(plain.irradiance({0, 0, 1})), 1.0,
                        1e-3);
        }
}

TEST(SunExtraction, NeedsASun) {
    const EnvironmentMap flat = made(grid(latlong, 64), [](TexelIndex) { return glm::dvec3(1.0); });
    EXPECT_FALSE(extract_sun(flat));
    const EnvironmentMap black = made(grid(latlong, 64), [](TexelIndex) { return glm::dvec3(0.0); });
    EXPECT_FALSE(extract_sun(black));
    const EnvironmentMap coarse = random_map(grid(latlong, 4));
    EXPECT_FALSE(extract_sun(coarse));
}

} // namespace
} // namespace gonio
