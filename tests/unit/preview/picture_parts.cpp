#include <gonio/media/layers.hpp>
#include <gonio/media/module.hpp>
#include <gonio/preview/picture_parts.hpp>
#include <gonio/scene/material.hpp>

#include "../folders.hpp"
#include "../light/lights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace gonio {
namespace {

RenderOptions small() {
    RenderOptions options;
    options.width = 80;
    options.height = 60;
    options.illuminance = true;
    return options;
}

// Lights of several kinds; two of them are visible, one in front of the other, and one is off.
std::vector<Light> lights() {
    std::vector<Light> all{light_of("sphere:r=15cm", "900lm", {0.0, -0.6, 1.5}),
                           light_of("rect:w=60cm,h=30cm", "1500lm", {0.1, 0.8, 1.6}),
                           light_of("spot:outer=35deg,inner=20deg", "900cd", {-0.8, 0.0, 2.2}),
                           light_of("sun:angle=0.53deg", "200lx", {}, {0.3, 0.4, -1.0}),
                           light_of("tube:r=3cm,l=60cm", "0lm", {0.6, -0.6, 1.2})};
    all[0].color = {1.3, 0.95, 0.6};
    return all;
}

// |a − b| relative to the larger; nearly dark pixels are compared with the picture's maximum.
void expect_near(const Image& found, const Image& expected, double relative) {
    ASSERT_EQ(found.pixels.size(), expected.pixels.size());
    const auto greatest = static_cast<double>(*std::max_element(expected.pixels.begin(), expected.pixels.end()));
    double worst = 0.0;
    for (std::size_t i = 0; i < found.pixels.size(); ++i) {
        const auto wanted = static_cast<double>(expected.pixels[i]);
        const double scale = std::fmax(std::fabs(wanted), 1e-3 * greatest);
        worst = std::fmax(worst, std::fabs(static_cast<double>(found.pixels[i]) - wanted) / scale);
    }
    EXPECT_LE(worst, relative);
}

void add(const Image& what, Image& to) {
    for (std::size_t i = 0; i < what.pixels.size(); ++i)
        to.pixels[i] += what.pixels[i];
}

// A sum of six floats in another order: five roundings of half a unit in the last place each, 6e-8, and as many in the
// sums that they are derived from.
constexpr double of_sums = 1e-6;

TEST(PictureParts, SharesOfLightsInAFileAddUpToThePicture) {
    media::set_module_folders({test::modules_folder});
    for (const char* stage_name : {"floor", "spheres"}) {
        const Stage stage = make_stage(stage_name).value();
        const std::vector<Light> all = lights();
        for (const IrradianceMethod method : {IrradianceMethod::exact, IrradianceMethod::frostbite}) {
            RenderOptions options = small();
            options.method = method;
            const Rendering picture = render(stage, all, stage.camera, options).value();
            media::LayeredImage layered = media::LayeredImage::create(80, 60, 3 + 4 * all.size()).value();
            layered.add("", picture.luminance_nt);
            const Rendering unlit = render_unlit(stage, all, stage.camera, options).value();
            EXPECT_TRUE(std::all_of(unlit.luminance_nt.pixels.begin(), unlit.luminance_nt.pixels.end(),
                                    [](float value) { return value == 0.0F; }));
            const auto added =
                render_each_light(stage, all, stage.camera, options, unlit, [&](std::size_t i, Rendering share) {
                    layered.add("light" + std::to_string(i), share.luminance_nt);
                    layered.add("lux" + std::to_string(i), share.illuminance_lx);
                    return Result<void>();
                });
            ASSERT_TRUE(added.has_value());
            const media::DecodedImage file = media::decode_image(layered.encode({}).value()).value();
            EXPECT_EQ(media::find_layer(file, "").value().pixels, picture.luminance_nt.pixels);
            Image sum(80, 60, 3);
            Image lux(80, 60, 1);
            for (std::size_t i = 0; i < all.size(); ++i) {
                const Image share = media::find_layer(file, "light" + std::to_string(i)).value();
                const bool is_dark =
                    std::all_of(share.pixels.begin(), share.pixels.end(), [](float value) { return value == 0.0F; });
                EXPECT_EQ(is_dark, i + 1 == all.size()) << i;
                add(share, sum);
                add(media::find_layer(file, "lux" + std::to_string(i)).value(), lux);
            }
            expect_near(sum, picture.luminance_nt, of_sums);
            expect_near(lux, picture.illuminance_lx, of_sums);
        }
    }
}

// A light alone on its stage gives the same picture wherever no other light covers what it lights.
TEST(PictureParts, ShareOfALightIsThatLight) {
    const Stage stage = make_stage("floor").value();
    const std::vector<Light> all{light_of("spot:outer=35deg", "900cd", {-0.8, 0.0, 2.2}),
                                 light_of("point", "900lm", {0.8, 0.0, 2.2})};
    std::vector<Image> shares;
    ASSERT_TRUE(render_each_light(stage, all, stage.camera, small(),
                                  render_unlit(stage, all, stage.camera, small()).value(),
                                  [&](std::size_t, Rendering share) {
                                      shares.push_back(std::move(share.luminance_nt));
                                      return Result<void>();
                                  })
                    .has_value());
    ASSERT_EQ(shares.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ(shares[i].pixels, render(stage, {&all[i], 1}, stage.camera, small()).value().luminance_nt.pixels);
}

TEST(PictureParts, OfEveryMaterialAddUpAndAreWhatTheyAreCalled) {
    Stage stage = make_stage("floor").value();
    const std::vector<Light> all = lights();
    RenderOptions options = small();
    for (const char* material :
         {"lambert:albedo=0.6", "eon:albedo=0.6,roughness=0.8", "frostbite:base=0.6,metal=0.3,smoothness=0.7",
          "ue4:base=0.6,metallic=0.3,cavity=0.7", "gltf:base=0.6,metallic=0.3",
          "blinn:albedo=0.6,wet=0.7,smoothness=0.4", "ggx:f0=0.7,alpha=0.2", "kulla-conty:f0=0.7,alpha=0.4",
          "gltf:base=0.6,coat=1", "ggx:f0=0.7,alpha=0.2,coat=0.5,coat-order=ue4"}) {
        for (Surface& surface : stage.surfaces)
            surface.material = parse_material(material).value();
        const Image picture = render(stage, all, stage.camera, options).value().luminance_nt;
        const PictureParts parts = picture_parts(picture, stage, all, stage.camera, options).value();
        Image sum = parts.emission_nt;
        add(parts.diffuse_nt, sum);
        add(parts.specular_nt, sum);
        expect_near(sum, picture, of_sums);
        const std::string kind(material);
        const auto greatest = [](const Image& image) {
            return *std::max_element(image.pixels.begin(), image.pixels.end());
        };
        EXPECT_GT(greatest(parts.emission_nt), 0.0F);
        EXPECT_EQ(greatest(parts.diffuse_nt) > 0.0F, !kind.starts_with("ggx") && !kind.starts_with("kulla")) << kind;
        EXPECT_EQ(greatest(parts.specular_nt) > 0.0F, !kind.starts_with("lambert") && !kind.starts_with("eon")) << kind;
        // No part is negative, except for rounding of the difference at the scale of the picture's brightness.
        for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
            EXPECT_GE(parts.specular_nt.pixels[i], -1e-5F * picture.pixels[i] - 1e-6F) << kind;
            EXPECT_GE(parts.diffuse_nt.pixels[i], -1e-5F * picture.pixels[i] - 1e-6F) << kind;
        }
    }
}

TEST(PictureParts, StopAtTheFirstFailure) {
    const Stage stage = make_stage("floor").value();
    const std::vector<Light> all = lights();
    int calls = 0;
    const auto stopped =
        render_each_light(stage, all, stage.camera, small(), render_unlit(stage, all, stage.camera, small()).value(),
                          [&](std::size_t i, Rendering) -> Result<void> {
                              ++calls;
                              if (i == 1) return fail(Failure::io, "full");
                              return {};
                          });
    EXPECT_FALSE(stopped.has_value());
    EXPECT_EQ(calls, 2);
    RenderOptions empty;
    empty.width = 0;
    EXPECT_FALSE(picture_parts({}, stage, all, stage.camera, empty).has_value());
}

} // namespace
} // namespace gonio
