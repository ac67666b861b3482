// Pictures of surfaces that emit, beside those of area lights in their place.
#include <gonio/preview/picture_parts.hpp>
#include <gonio/preview/reference_picture.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/emissive_lights.hpp>

#include "../light/lights.hpp"
#include "../scaled.hpp"
#include "../scene/emitted.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace gonio {
namespace {

using test::emitted_by;
using Vec = glm::dvec3;

const Material polished = Ue4Material{Vec(0.4), 0.35};
const Material black = LambertMaterial{Vec(0.0)};

Stage surroundings() {
    Stage stage;
    stage.surfaces = {{"floor", Plane{}, polished},
                      {"crate", Box{{{0.7, 0.3, 0.25}}, Vec(0.25)}, LambertMaterial{{0.6, 0.3, 0.2}}},
                      {"wall", Plane{{0.0, 1.5, 0.0}, {0.0, -1.0, 0.0}}, LambertMaterial{Vec(0.6)}}};
    stage.camera = {{0.4, -3.0, 1.3}, {0.2, 0.0, 0.5}};
    return stage;
}

Stage with_emitter(const Primitive& geometry, const Material& material, const char* emits) {
    Stage stage = surroundings();
    stage.surfaces.push_back({"lamp", geometry, material});
    if (emits != nullptr) stage.surfaces.back().emits = parse_surface_emission(emits).value();
    return stage;
}

RenderOptions small() {
    RenderOptions options;
    options.width = 96;
    options.height = 72;
    options.illuminance = true;
    return options;
}

Rendering picture(const Stage& stage, const std::vector<Light>& lights, const RenderOptions& options = small()) {
    return render(stage, lights, stage.camera, options).value();
}

// A black surface that emits is an area light, which does not reflect either: the same picture to the last bit. A
// single light, since area lights do not hide others.
TEST(SurfaceEmission, ABlackEmitterIsAnAreaLight) {
    struct Case {
        Primitive geometry;
        Light light;
    };
    const Vec towards = glm::normalize(Vec(0.3, -1.0, -0.2));
    const std::array cases{
        Case{Ball{{-0.2, 0.2, 0.7}, 0.2}, light_of("sphere:r=20cm", "500nt", {-0.2, 0.2, 0.7})},
        Case{Capsule{{-0.2, 0.2, 0.7}, {1, 0, 0}, 0.3, 0.05},
             light_of("tube:r=5cm,l=60cm", "500nt", {-0.2, 0.2, 0.7}, {0, 0, -1}, {0, 1, 0})},
        Case{panel_facing({-0.2, 0.4, 0.7}, towards, {0, 0, 1}, 0.6, 0.4),
             light_of("rect:w=60cm,h=40cm", "500nt", {-0.2, 0.4, 0.7}, towards, {0, 0, 1})},
    };
    for (const Case& one : cases)
        for (const Shadows shadows : {Shadows::soft, Shadows::hard}) {
            const Stage stage = with_emitter(one.geometry, black, "500nt");
            RenderOptions options = small();
            options.shadows = shadows;
            const Rendering emitting = picture(stage, emitted_by(stage), options);
            const Rendering lit = picture(surroundings(), {one.light}, options);
            ASSERT_GT(std::count(lit.shows_light.begin(), lit.shows_light.end(), 1), 20);
            EXPECT_EQ(emitting.shows_light, lit.shows_light);
            // Frames of lights that are put there by hand differ in the last digits of a double.
            double worst = 0.0;
            for (std::size_t i = 0; i < lit.luminance_nt.pixels.size(); ++i)
                worst = std::fmax(worst, std::fabs(static_cast<double>(emitting.luminance_nt.pixels[i]) -
                                                   static_cast<double>(lit.luminance_nt.pixels[i])) /
                                             (1e-3 + static_cast<double>(lit.luminance_nt.pixels[i])));
            EXPECT_LE(worst, 1e-6) << one.geometry.index();
            ASSERT_EQ(emitting.partial_lights.size(), lit.partial_lights.size());
            for (std::size_t i = 0; i < lit.partial_lights.size(); ++i) {
                EXPECT_EQ(emitting.partial_lights[i].pixel, lit.partial_lights[i].pixel);
                EXPECT_EQ(emitting.partial_lights[i].share, lit.partial_lights[i].share);
                EXPECT_EQ(emitting.partial_lights[i].rgb, lit.partial_lights[i].rgb);
            }
        }
}

// Light adds up: what a stage shows under a lamp and with an emitter is the sum of both, by every way of light.
TEST(SurfaceEmission, ComesInAdditionToReflection) {
    const std::array geometries{Primitive(Ball{{-0.2, 0.2, 0.7}, 0.2}), Primitive(Box{{{-0.3, 0.4, 0.4}}, Vec(0.2)})};
    for (const Primitive& geometry : test::scaled(geometries))
        for (const int bounces : {0, all_bounces}) {
            RenderOptions options = small();
            options.bounces = bounces;
            const Light lamp = light_of("sphere:r=10cm", "900lm", {0.4, -0.9, 1.9});
            const Stage emitting = with_emitter(geometry, polished, "80nt,color=rgb(1,0.6,0.3)");
            std::vector<Light> lights = emitted_by(emitting);
            const Rendering alone = picture(emitting, lights, options);
            const Rendering dark = picture(with_emitter(geometry, polished, nullptr), {lamp}, options);
            lights.push_back(lamp);
            const Rendering both = picture(emitting, lights, options);
            // Patches are smaller near lights: with the lamp, other ones.
            const double greatest = static_cast<double>(
                *std::max_element(both.luminance_nt.pixels.begin(), both.luminance_nt.pixels.end()));
            double worst = 0.0;
            for (std::size_t i = 0; i < both.luminance_nt.pixels.size(); ++i)
                worst = std::fmax(worst, std::fabs(static_cast<double>(both.luminance_nt.pixels[i]) -
                                                   static_cast<double>(alone.luminance_nt.pixels[i]) -
                                                   static_cast<double>(dark.luminance_nt.pixels[i])));
            EXPECT_LE(worst / greatest, bounces == 0 ? 1e-6 : 2e-3);
        }
}

// On the outline, the part of a pixel that the emitter fills shows what it reflects, too: as much as the pixels beside.
TEST(SurfaceEmission, PartsOfPixelsShowTheReflectionOfTheEmitter) {
    const Stage stage = with_emitter(Ball{{-0.2, 0.2, 0.7}, 0.3}, LambertMaterial{Vec(0.8)}, "1nt");
    std::vector<Light> lights = emitted_by(stage);
    lights.push_back(light_of("point", "4000lm", {-0.2, -3.0, 0.7}));
    const Rendering rendered = picture(stage, lights);
    ASSERT_GT(rendered.partial_lights.size(), 20U);
    for (const PartialLight& part : rendered.partial_lights)
        if (part.share > 0.9F) {
            const float whole = rendered.luminance_nt.pixels[std::size_t{part.pixel} * 3];
            EXPECT_GT(part.rgb[0], 1.2F); // not its emission alone
            EXPECT_NEAR(static_cast<double>(part.rgb[0] / whole), 1.0, 0.25);
        }
}

TEST(SurfaceEmission, SharesOfLightsAddUp) {
    const Stage stage = with_emitter(Box{{{-0.3, 0.4, 0.4}}, Vec(0.2)}, polished, "80nt");
    std::vector<Light> lights = emitted_by(stage);
    lights.push_back(light_of("sphere:r=10cm", "900lm", {0.4, -0.9, 1.9}));
    RenderOptions options = small();
    const Rendering all = picture(stage, lights, options);
    const Rendering unlit = render_unlit(stage, lights, stage.camera, options).value();
    std::vector<double> sum(all.luminance_nt.pixels.size(), 0.0);
    ASSERT_TRUE(render_each_light(stage, lights, stage.camera, options, unlit, [&](std::size_t, Rendering share) {
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += static_cast<double>(share.luminance_nt.pixels[i]);
        return Result<void>();
    }));
    for (std::size_t i = 0; i < sum.size(); ++i)
        EXPECT_NEAR(sum[i], static_cast<double>(all.luminance_nt.pixels[i]), 1e-6 * 80.0 + 1e-6 * sum[i]);
    const PictureParts parts = picture_parts(all.luminance_nt, stage, lights, stage.camera, options).value();
    const auto shown = static_cast<std::size_t>(std::find(all.shows_light.begin(), all.shows_light.end(), 1) -
                                                all.shows_light.begin());
    ASSERT_LT(shown, all.shows_light.size());
    const float greatest = *std::max_element(parts.emission_nt.pixels.begin(), parts.emission_nt.pixels.end());
    EXPECT_GE(greatest, 80.0F);
}

// The path-traced reference, and the quadrature at each point, know emitters as the fast method does.
TEST(SurfaceEmission, TheReferencesAgree) {
    const Stage stage = with_emitter(Box{{{-0.3, 0.4, 0.4}}, Vec(0.2)}, polished, "80nt");
    const std::vector<Light> lights = emitted_by(stage);
    for (const int bounces : {0, all_bounces}) {
        RenderOptions options;
        options.width = 48;
        options.height = 36;
        options.bounces = bounces;
        const Rendering fast = picture(stage, lights, options);
        ReferencePicture reference = ReferencePicture::begin(stage, lights, stage.camera, options).value();
        for (int pass = 0; pass < 64; ++pass)
            reference.add_pass();
        const Rendering traced = reference.picture();
        double of_fast = 0.0;
        double of_traced = 0.0;
        constexpr std::size_t side = 6; // of blocks of pixels, whose means have less noise
        std::vector<double> blocks((48 / side) * (36 / side), 0.0);
        for (std::size_t i = 0; i < fast.luminance_nt.pixels.size(); ++i) {
            of_fast += static_cast<double>(fast.luminance_nt.pixels[i]);
            of_traced += static_cast<double>(traced.luminance_nt.pixels[i]);
            const std::size_t pixel = i / 3;
            blocks[pixel / 48 / side * (48 / side) + pixel % 48 / side] +=
                static_cast<double>(fast.luminance_nt.pixels[i] - traced.luminance_nt.pixels[i]);
        }
        double apart = 0.0;
        for (const double block : blocks)
            apart += std::fabs(block);
        EXPECT_NEAR(of_traced / of_fast, 1.0, 1e-2);
        EXPECT_LT(apart / of_fast, 2e-2);
        EXPECT_GT(std::count(traced.shows_light.begin(), traced.shows_light.end(), 1), 50);
    }
}

TEST(SurfaceEmission, NothingIsLostBySkipping) {
    const Stage stage = with_emitter(Box{{{-0.3, 0.4, 0.4}}, Vec(0.2)}, polished, "80nt");
    std::vector<Light> lights = emitted_by(stage);
    lights.push_back(light_of("sphere:r=10cm", "900lm", {0.4, -0.9, 1.9}));
    RenderOptions options = small();
    const Rendering skipping = picture(stage, lights, options);
    options.skip = false;
    options.threads = 1;
    EXPECT_EQ(picture(stage, lights, options).luminance_nt.pixels, skipping.luminance_nt.pixels);
}

} // namespace
} // namespace gonio
