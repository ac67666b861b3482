#include <gonio/preview/path_tracer.hpp>
#include <gonio/preview/reference_picture.hpp>
#include <gonio/transport/interreflection.hpp>

#include "../transport/stages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gonio {
namespace {

using detail::indirect_by_paths;
using detail::IndirectEstimate;
using detail::PathTracer;
using test::bulb;
using test::Vec;

PathTracer::Options bouncing(int bounces = all_bounces) {
    PathTracer::Options options;
    options.bounces = bounces;
    return options;
}

Hit on(std::size_t surface, const Vec& at, const Vec& normal) {
    return {0.0, surface, 0, at, normal};
}

// Within four standard errors, of which there must be few.
void expect_estimate(const IndirectEstimate& estimate, double lx, double most_error) {
    EXPECT_LT(estimate.standard_error_lx.x, most_error * lx);
    EXPECT_NEAR(estimate.lx.x, lx, 4.0 * estimate.standard_error_lx.x + 1e-4 * lx);
}

TEST(PathTracer, BoxOfSixReflectances) {
    const Stage stage = test::stage_of(test::six_reflectances);
    const Light light = bulb(test::six_reflectances.light, test::six_reflectances.intensity_cd);
    const PathTracer tracer(stage, {&light, 1}, bouncing());
    std::uint32_t seed = 1;
    for (const test::WallPoint& point : test::wall_points)
        expect_estimate(indirect_by_paths(tracer, on(point.face, point.at, test::inwards(point.face)), 40000, ++seed),
                        point.indirect_lx, 8e-3);
}

TEST(PathTracer, TwoInfinitePlanes) {
    const Stage stage = test::two_planes();
    const Light light = bulb({0.0, 0.0, 2.0}, 100.0);
    const PathTracer tracer(stage, {&light, 1}, bouncing());
    const PathTracer once(stage, {&light, 1}, bouncing(1));
    for (const test::PlanesRow& row : test::planes_rows) {
        expect_estimate(indirect_by_paths(tracer, on(0, {row.r, 0.0, 0.0}, {0.0, 0.0, 1.0}), 40000, 3), row.below_lx,
                        2e-2);
        expect_estimate(indirect_by_paths(tracer, on(1, {0.0, row.r, 3.0}, {0.0, 0.0, -1.0}), 40000, 4), row.above_lx,
                        2e-2);
    }
    expect_estimate(indirect_by_paths(once, on(0, Vec(0.0), {0.0, 0.0, 1.0}), 40000, 5), test::one_bounce_lx, 1e-2);
}

// Many lights, of which each vertex draws one, are as bright as one by one.
TEST(PathTracer, DrawsAmongManyLights) {
    const Stage stage = test::stage_of(test::six_reflectances);
    std::vector<Light> lights;
    for (int i = 0; i < 10; ++i)
        lights.push_back(bulb(test::six_reflectances.light + Vec(0.2 * i, 0.1 * i, -0.1 * i), 10.0 * (i + 1)));
    const Hit hit = on(4, {2.5, 2.0, 0.0}, {0.0, 0.0, 1.0});
    double sum = 0.0;
    double variance = 0.0;
    for (const Light& light : lights) {
        const PathTracer alone(stage, {&light, 1}, bouncing());
        const IndirectEstimate estimate = indirect_by_paths(alone, hit, 8000, 7);
        sum += estimate.lx.x;
        variance += estimate.standard_error_lx.x * estimate.standard_error_lx.x;
    }
    const PathTracer together(stage, lights, bouncing());
    const IndirectEstimate estimate = indirect_by_paths(together, hit, 40000, 8);
    EXPECT_NEAR(estimate.lx.x, sum, 4.0 * std::sqrt(variance) + 4.0 * estimate.standard_error_lx.x);
    EXPECT_LT(estimate.standard_error_lx.x, 1e-2 * sum);
}

TEST(PathTracer, PassesAreTheSameAtAnyNumberOfThreads) {
    const Stage stage = make_stage("room").value();
    const Light light = bulb({0.0, 0.3, 2.3}, 100.0);
    const auto picture_of = [&](unsigned threads, int bounces) {
        RenderOptions options;
        options.width = options.height = 24;
        options.threads = threads;
        options.bounces = bounces;
        options.illuminance = true;
        auto picture = ReferencePicture::begin(stage, {&light, 1}, stage.camera, options).value();
        for (int pass = 0; pass < 4; ++pass)
            picture.add_pass();
        return picture.picture();
    };
    const Rendering alone = picture_of(1, all_bounces);
    const Rendering shared = picture_of(3, all_bounces);
    EXPECT_EQ(alone.luminance_nt.pixels, shared.luminance_nt.pixels);
    EXPECT_EQ(alone.illuminance_lx.pixels, shared.illuminance_lx.pixels);
    // Bounces only add light.
    const Rendering direct = picture_of(1, 0);
    for (std::size_t i = 0; i < direct.luminance_nt.pixels.size(); ++i)
        EXPECT_GE(alone.luminance_nt.pixels[i], direct.luminance_nt.pixels[i]);
}

} // namespace
} // namespace gonio
