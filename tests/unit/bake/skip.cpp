// Skipping does not change the result: mirror images, dark rows and texels, and runs of texels in packs.
#include <gonio/bake/bake.hpp>
#include <gonio/bake/kernels.hpp>
#include <gonio/bake/latlong.hpp>
#include <gonio/bake/mirror_images.hpp>
#include <gonio/web/symmetry.hpp>

#include "../web/webs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace gonio {
namespace {

using test::random_web;
using test::steps;

struct Case {
    Layout layout;
    int width;
    int height;
};

constexpr Case cases[] = {
    {Layout::latlong, 64, 32},     {Layout::latlong, 63, 31},    {Layout::latlong, 66, 33},
    {Layout::latlong, 1, 1},       {Layout::latlong, 2, 2},      {Layout::latlong, 1000, 50},
    {Layout::v180, 90, 1},         {Layout::octahedral, 23, 23}, {Layout::octahedral_equal_area, 22, 22},
    {Layout::cube_strip, 120, 20}, {Layout::cube_cross, 84, 63}, {Layout::gnomonic, 20, 20},
    {Layout::panorama, 36, 18},
};

// Dark beyond some γ, one of each symmetry; values without a pattern.
std::vector<Web> some_webs() {
    std::vector<Web> webs;
    webs.push_back(random_web(Symmetry::axial, {0}, {0, 3, 7.5, 40, 90}, 1));
    webs.push_back(random_web(Symmetry::quadrant, {0, 11, 45, 90}, steps(0, 90, 19), 2));
    webs.push_back(random_web(Symmetry::bilateral_0_180, steps(0, 180, 13), steps(0, 120, 37), 3));
    webs.push_back(random_web(Symmetry::bilateral_90_270, steps(90, 270, 13), steps(30, 150, 25), 4));
    webs.push_back(random_web(Symmetry::none, steps(0, 360, 25), steps(90, 180, 19), 5));
    std::mt19937 random(7);
    for (const Photometry type : {Photometry::a, Photometry::b}) {
        const std::vector<double> h = steps(0, 90, 7);
        const std::vector<double> v = steps(0, 80, 5);
        std::vector<double> candela(h.size() * v.size());
        for (double& cd : candela)
            cd = static_cast<double>(random() % 1000);
        webs.push_back(*Web::create(type, Symmetry::quadrant, h, v, candela));
    }
    return webs;
}

std::string name(const Case& size, const Web& web) {
    return std::string(info_of(size.layout).name) + ' ' + std::to_string(size.width) + 'x' +
           std::to_string(size.height) + ' ' + to_text(web.stored_symmetry()) + " type " +
           std::to_string(static_cast<int>(web.photometry()));
}

TEST(BakeSkip, LeavesEveryTexelTheSame) {
    for (const Web& web : some_webs())
        for (const Case& size : cases)
            for (const TexelType type : {TexelType::float32, TexelType::half}) {
                BakeOptions options;
                options.layout = size.layout;
                options.width = size.width;
                options.height = size.height;
                options.texel_type = type;
                options.normalization = Normalization::peak;
                const Texture quick = bake_texture(web, options).value();
                options.skip = false;
                const Texture whole = bake_texture(web, options).value();
                EXPECT_EQ(quick.image.pixels, whole.image.pixels) << name(size, web);
                for (const float texel : whole.image.pixels)
                    ASSERT_FALSE(std::signbit(texel)) << name(size, web);
                EXPECT_EQ(whole.evaluated, whole.texels) << name(size, web);
                EXPECT_NEAR(quick.texture_flux.value, whole.texture_flux.value, 1e-12 * whole.texture_flux.value);
                EXPECT_NEAR(quick.quantization_error.value, whole.quantization_error.value, 1e-10 * whole.peak.value);
                EXPECT_NEAR(quick.max_error.value, whole.max_error.value, 1e-10 * whole.peak.value);
            }
}

// The fraction of texels that is evaluated: half are dark, and of the others one of each set of mirror images.
TEST(BakeSkip, EvaluatesWhatDiffers) {
    const auto share = [](const Web& web, Layout layout, int width, int height) {
        BakeOptions options;
        options.layout = layout;
        options.width = width;
        options.height = height;
        const Texture texture = bake_texture(web, options).value();
        return static_cast<double>(texture.evaluated) / static_cast<double>(texture.texels);
    };
    const Web axial = random_web(Symmetry::axial, {0}, steps(0, 90, 10), 1);
    const Web quadrant = random_web(Symmetry::quadrant, {0, 11, 45, 90}, steps(0, 90, 19), 2);
    EXPECT_EQ(share(axial, Layout::latlong, 64, 32), 0.5 / 64);
    EXPECT_EQ(share(axial, Layout::v180, 64, 1), 0.5);
    EXPECT_EQ(share(quadrant, Layout::latlong, 64, 32), 0.5 / 4);
    // The texels around the horizon are evaluated too.
    EXPECT_NEAR(share(axial, Layout::octahedral, 128, 128), 0.5 / 8, 0.01);
    EXPECT_NEAR(share(quadrant, Layout::octahedral_equal_area, 128, 128), 0.5 / 4, 0.02);
    EXPECT_NEAR(share(axial, Layout::cube_strip, 384, 64), 0.5 / 8, 0.01);
    EXPECT_NEAR(share(quadrant, Layout::panorama, 128, 64), 0.5 / 4, 0.02);
    EXPECT_NEAR(share(quadrant, Layout::gnomonic, 64, 64), 1.0 / 4, 0.001);
}

// A table written out in full still has its symmetry, and the mirror images of a light do not depend on how it is
// stored: the expanded web stores no mirror.
TEST(BakeSkip, ImagesAreThoseOfTheLight) {
    for (const Web& web : some_webs()) {
        const Web written_out = expanded(web);
        for (const Case& size : cases) {
            BakeOptions options;
            options.layout = size.layout;
            options.width = size.width;
            options.height = size.height;
            const Texture quick = bake_texture(web, options).value();
            options.skip = false;
            const Texture whole = bake_texture(written_out, options).value();
            for (std::size_t i = 0; i < quick.image.pixels.size(); ++i)
                ASSERT_NEAR(quick.image.pixels[i], whole.image.pixels[i], 1.3e-7 * 1000) << name(size, web) << ' ' << i;
        }
    }
}

TEST(MirrorImages, AreWholeTexels) {
    const Web web = random_web(Symmetry::axial, {0}, {0, 90}, 1);
    for (const auto& [size, images] : {std::pair{Case{Layout::octahedral, 8, 8}, std::size_t{8}},
                                       {Case{Layout::octahedral_equal_area, 8, 8}, std::size_t{8}},
                                       {Case{Layout::cube_strip, 36, 6}, std::size_t{8}},
                                       {Case{Layout::cube_cross, 24, 18}, std::size_t{8}},
                                       {Case{Layout::gnomonic, 8, 8}, std::size_t{8}},
                                       {Case{Layout::panorama, 8, 4}, std::size_t{4}}}) {
        const std::vector<PlacedChart> charts = charts_of(size.layout, size.width, size.height, {}).value();
        const MirrorImages mirrors(charts, web);
        std::size_t most = 0;
        std::size_t first = 0;
        std::size_t counted = 0;
        std::size_t all = 0;
        for (std::size_t k = 0; k < charts.size(); ++k)
            for (int row = 0; row < charts[k].height; ++row)
                for (int column = 0; column < charts[k].width; ++column) {
                    const TexelPlace texel{k, column, row};
                    ++all;
                    most = std::max(most, mirrors.count_of(texel));
                    if (mirrors.first_of(texel) != texel) continue;
                    ++first;
                    counted += mirrors.count_of(texel);
                    EXPECT_EQ(mirrors.first_of(mirrors.first_of(texel)), mirrors.first_of(texel));
                }
        EXPECT_EQ(most, images) << info_of(size.layout).name;
        EXPECT_EQ(counted, all) << info_of(size.layout).name;
        EXPECT_LT(first, all);
    }
}

// The fast rows against the plain sums of latlong.hpp: the floats differ at most by their rounding.
TEST(BakeLatlong, RunsAreTheClosedForm) {
    for (const Web& web : some_webs()) {
        if (web.photometry() != Photometry::c) continue;
        for (const auto& [width, height] : {std::pair{1, 1}, {7, 5}, {48, 24}, {500, 60}, {1023, 40}}) {
            BakeOptions options;
            options.width = width;
            options.height = height;
            const Texture texture = bake_texture(web, options).value();
            const LatlongMeans means(web, width);
            std::vector<double> row(static_cast<std::size_t>(width));
            double error = 0.0;
            for (int j = 0; j < height; ++j) {
                means.row(180.0 * j / height, 180.0 * (j + 1) / height, row);
                for (int i = 0; i < width; ++i) {
                    const double mean = row[static_cast<std::size_t>(i)];
                    EXPECT_NEAR(*texture.image.at(i, j), mean, 6e-8 * mean + 1e-12) << i << ' ' << j;
                    error =
                        std::max(error, std::abs(*texture.image.at(i, j) -
                                                 web.candela((i + 0.5) / width * 360.0, (j + 0.5) / height * 180.0)));
                }
            }
            EXPECT_GE(texture.max_error.value, error * (1.0 - 1e-9)) << width;
        }
    }
}

// Packs of every instruction set and every remainder of a packet, against as_stored(), to the last bit.
TEST(BakeKernels, AgreeOnEveryInstructionSet) {
    const bake::Ramp ramps[] = {{-3.0, 0.37, -2.9, 0.36}, {1.0, -0.013, 1.0, -0.012}, {0.5, 0.0, 0.5, 0.0}};
    for (const TexelType type : {TexelType::float32, TexelType::half, TexelType::uint16, TexelType::uint8})
        for (const bake::Ramp& ramp : ramps)
            for (std::size_t count = 1; count <= 40; ++count) {
                std::vector<float> plain(count);
                bake::RampTotals totals;
                for (std::size_t k = 0; k < count; ++k) {
                    const auto at = static_cast<double>(k);
                    const double mean = at * ramp.mean_step + ramp.mean;
                    const double kept = as_stored(type, std::max(mean, 0.0));
                    plain[k] = static_cast<float>(kept);
                    totals.error = std::max(totals.error, std::abs(kept - (at * ramp.center_step + ramp.center)));
                    totals.rounding = std::max(totals.rounding, std::abs(kept - std::max(mean, 0.0)));
                    totals.least = std::min(totals.least, mean);
                    totals.sum += kept;
                }
                double sum = 0.0;
                for (const simd::InstructionSet set : simd::available_sets()) {
                    std::vector<float> texels(count + 1, 99.0F);
                    const bake::RampTotals by_packs = bake::kernels(set).store_ramp(ramp, type, texels.data(), count);
                    EXPECT_EQ(texels.back(), 99.0F) << simd::to_text(set) << ' ' << count;
                    texels.pop_back();
                    EXPECT_EQ(texels, plain) << simd::to_text(set) << ' ' << count;
                    EXPECT_EQ(by_packs.error, totals.error) << simd::to_text(set) << ' ' << count;
                    EXPECT_EQ(by_packs.rounding, totals.rounding) << simd::to_text(set) << ' ' << count;
                    EXPECT_EQ(by_packs.least, totals.least) << simd::to_text(set) << ' ' << count;
                    EXPECT_NEAR(by_packs.sum, totals.sum, 1e-14 * static_cast<double>(count) * (1.0 + totals.sum));
                    if (set == simd::InstructionSet::scalar) sum = by_packs.sum;
                    EXPECT_EQ(by_packs.sum, sum) << simd::to_text(set) << ' ' << count;
                }
            }
}

} // namespace
} // namespace gonio
