// Stages with surfaces that emit.
#include <gonio/preview/path_tracer.hpp>
#include <gonio/scene/emissive_lights.hpp>
#include <gonio/transport/receiver_light.hpp>

#include "../scaled.hpp"
#include "../scene/emitted.hpp"
#include "stages.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace gonio {
namespace {

using std::numbers::pi;
using test::emitted_by;
using test::Vec;

// Closed, of one albedo and one luminance everywhere.
constexpr double albedo = 0.6;
constexpr double own_nt = 100.0;
constexpr double all_nt = own_nt / (1.0 - albedo);

Stage furnace() {
    Stage stage = test::stage_of({{3.0, 4.0, 2.5}, {albedo, albedo, albedo, albedo, albedo, albedo}, {}, 0.0});
    stage.surfaces.push_back({"sphere", Ball{{1.0, 1.2, 0.9}, 0.4}, LambertMaterial{Vec(albedo)}});
    stage.surfaces.push_back(
        {"capsule", capsule_between({2.0, 3.0, 0.6}, {2.4, 2.6, 1.6}, 0.2), LambertMaterial{Vec(albedo)}});
    stage.surfaces.push_back({"box", Box{{{1.2, 3.0, 1.2}}, {0.3, 0.2, 0.4}}, LambertMaterial{Vec(albedo)}});
    for (Surface& surface : stage.surfaces)
        surface.emits = parse_surface_emission("100nt").value();
    return stage;
}

const std::array receivers{Receiver{{1.5, 2.0, 1.2}, {0.2, 0.4, 1.0}}, Receiver{{2.2, 0.6, 0.4}, {-1.0, 0.5, -0.3}},
                           Receiver{{0.5, 3.3, 2.0}, {0.3, -1.0, -0.2}}};

std::vector<double> lit_lx(const Stage& stage, const std::vector<Light>& lights, int bounces) {
    LightingOptions options;
    options.bounces = bounces;
    const ReceiverLight::Shares shares = ReceiverLight::on(stage, lights, options).value().at(receivers);
    ProbeOptions parts;
    parts.parts = true;
    const ProbeResult direct = probe(lights, receivers, parts).value();
    std::vector<double> lx = shares.indirect_lx;
    for (std::size_t i = 0; i < direct.parts_lx.size(); ++i)
        lx[i / lights.size()] += shares.visible[i] * direct.parts_lx[i];
    return lx;
}

// Everything in sight has the same luminance L: the lux are π L, direct ones and with all bounces. If a surface hid its
// own light, received it or sent it twice, they would not be. A light as wide as a wall behind solids is known to 2 %
// of it (preview/README.md), all of them together to less.
TEST(SurfaceEmission, InAFurnaceEverythingIsAlike) {
    if (test::is_sanitized) GTEST_SKIP() << "ComesInAdditionToReflection has emitters with all bounces";
    const Stage stage = furnace();
    const std::vector<Light> lights = emitted_by(stage);
    ASSERT_EQ(lights.size(), 6U + 1U + 1U + 6U);
    for (const double lx : lit_lx(stage, lights, 0))
        EXPECT_NEAR(lx / (pi * own_nt), 1.0, 1e-2);
    for (const double lx : lit_lx(stage, lights, all_bounces))
        EXPECT_NEAR(lx / (pi * all_nt), 1.0, 1e-2);
}

// A receiver between a wide light and what stands before it is in shadow, though it is nearer to the middle of the
// light than its corners are.
TEST(SurfaceEmission, NearAWallThatEmitsThereIsShadow) {
    Stage stage;
    stage.surfaces = {{"wall", panel_facing({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 6.0, 6.0), {}},
                      {"box", Box{{{0.0, 0.0, 0.5}}, {0.8, 0.8, 0.1}}, {}}};
    stage.surfaces[0].emits = parse_surface_emission("500nt").value();
    const std::vector<Light> lights = emitted_by(stage);
    const std::array behind{Receiver{{0.0, 0.0, 0.7}, {0, 0, -1}}};
    const std::array open{Receiver{{0.0, 0.0, 0.3}, {0, 0, -1}}};
    const LightingOptions options;
    const ReceiverLight light = ReceiverLight::on(stage, lights, options).value();
    EXPECT_LT(light.at(behind).visible[0], 0.2);
    EXPECT_EQ(light.at(open).visible[0], 1.0);
}

// Unlike the solution, the path tracer is without bias: four standard errors.
TEST(SurfaceEmission, PathsInAFurnaceAgree) {
    const Stage stage = furnace();
    const std::vector<Light> lights = emitted_by(stage);
    detail::PathTracer::Options options;
    options.bounces = all_bounces;
    const detail::PathTracer tracer(stage, lights, options);
    const std::array hits{Hit{0.0, 4, 0, {2.0, 2.0, 0.0}, {0.0, 0.0, 1.0}},
                          Hit{0.0, 6, 0, {1.0, 1.2, 1.3}, {0.0, 0.0, 1.0}},
                          Hit{0.0, 8, 4, {1.25, 3.05, 1.6}, {0.0, 0.0, 1.0}}};
    std::uint32_t pixel = 0;
    for (const Hit& hit : hits) {
        constexpr int groups = 32;
        constexpr int paths = 400;
        std::array<double, groups> means{};
        double mean = 0.0;
        for (double& group : means) {
            ++pixel;
            for (int i = 0; i < paths; ++i)
                group +=
                    tracer.at(hit, hit.normal, detail::PixelSequence(static_cast<std::size_t>(i), pixel)).rgb.x / paths;
            mean += group / groups;
        }
        double variance = 0.0;
        for (const double group : means)
            variance += (group - mean) * (group - mean) / (groups * (groups - 1));
        const double error = std::sqrt(variance);
        EXPECT_LT(error, 5e-3 * all_nt);
        EXPECT_NEAR(own_nt + mean, all_nt, 4.0 * error);
    }
}

// A surface that emits shades the light of others, but not its own.
TEST(SurfaceEmission, ASurfaceHidesOtherLights) {
    Stage stage;
    stage.surfaces = {{"floor", Plane{}, {}}, {"sphere", Ball{{0.0, 0.0, 1.0}, 0.3}, {}}};
    stage.surfaces[1].emits = parse_surface_emission("500nt").value();
    std::vector<Light> lights = emitted_by(stage);
    lights.push_back(test::bulb({0.0, 0.0, 2.0}, 100.0));
    const std::array on_floor{Receiver{{0.0, 0.0, 0.0}, {0, 0, 1}}, Receiver{{3.0, 0.0, 0.0}, {0, 0, 1}}};
    for (const Shadows shadows : {Shadows::soft, Shadows::hard}) {
        LightingOptions options;
        options.shadows = shadows;
        const ReceiverLight::Shares shares = ReceiverLight::on(stage, lights, options).value().at(on_floor);
        EXPECT_EQ(shares.visible, (std::vector<double>{1.0, 0.0, 1.0, 1.0}));
    }
}

} // namespace
} // namespace gonio
