// What glossy surfaces throw on others, against the sum over the points of the surface.
#include <gonio/scene/core_vector.hpp>
#include <gonio/shading/brdf.hpp>
#include <gonio/transport/interreflection.hpp>
#include <gonio/transport/thrown_light.hpp>

#include "stages.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <variant>
#include <vector>

namespace gonio {
namespace {

using detail::vec;
using test::bulb;
using test::Vec;

constexpr double side_m = 4.0;
constexpr double height_m = 2.5;
constexpr Vec up{0.0, 0.0, 1.0};

// A polished metal floor below a black ceiling.
Stage floor_and_ceiling(double alpha) {
    Stage stage;
    stage.camera = {{0.0, -3.0, 1.0}, {0.0, 0.0, 1.0}};
    stage.light.position = {0.3, -0.2, 1.5};
    stage.surfaces = {
        {"floor", panel_facing(Vec(0.0), up, {0.0, 1.0, 0.0}, side_m, side_m), GgxMaterial{Vec(0.9, 0.6, 0.3), alpha}},
        {"ceiling", panel_facing({0.0, 0.0, height_m}, -up, {0.0, 1.0, 0.0}, side_m, side_m),
         LambertMaterial{Vec(0.0)}}};
    return stage;
}

// Of light at `from` that the floor reflects once.
Vec thrown_lx(const CoreMaterial& floor, const Light& light, const Vec& at) {
    constexpr int steps = 300;
    constexpr double step_m = side_m / steps;
    Vec lx(0.0);
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const Vec point{(i + 0.5) * step_m - 0.5 * side_m, (j + 0.5) * step_m - 0.5 * side_m, 0.0};
            const Vec to_light = light.frame.origin - point;
            const Vec away = at - point;
            const double light2 = glm::dot(to_light, to_light);
            const double away2 = glm::dot(away, away);
            const Vec l = to_light / std::sqrt(light2);
            const Vec v = away / std::sqrt(away2);
            const double illuminance_lx = light.intensity.value * l.z / light2;
            lx += illuminance_lx * v.z * v.z * step_m * step_m / away2 *
                  std::visit([&](const auto& of) { return vec(brdf(of, vec(up), vec(l), vec(v))); }, floor);
        }
    return lx;
}

Interreflection once(const Stage& stage, std::span<const Light> lights) {
    LightingOptions options;
    options.bounces = 1;
    return Interreflection::of(stage, lights, options).value();
}

TEST(ThrownLight, IsThatOfAllPointsOfTheFloor) {
    const Stage stage = floor_and_ceiling(0.25);
    const Light light = bulb(stage.light.position, 100.0);
    const Interreflection indirect = once(stage, {&light, 1});
    const CoreMaterial floor = core_material(stage.surfaces[0].material);
    const Vec brightest = thrown_lx(floor, light, {0.3, -0.2, height_m});
    for (const Vec& at : {Vec(0.3, -0.2, height_m), Vec(0.9, 0.4, height_m), Vec(-1.0, 1.0, height_m),
                          Vec(1.8, -1.8, height_m), Vec(0.0, 1.9, height_m)}) {
        const Vec expected = thrown_lx(floor, light, at);
        const Vec between_nodes = indirect.on_surface(1, 0, at);
        const Vec own_rays = indirect.at(at, -up);
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(between_nodes[channel], expected[channel], 0.025 * brightest[channel]) << at.x << ' ' << at.y;
            EXPECT_NEAR(own_rays[channel], expected[channel], 0.01 * brightest[channel]) << at.x << ' ' << at.y;
        }
    }
}

// Lobes that no ray would find are widened, which blurs what they throw and keeps how much it is.
TEST(ThrownLight, OfNarrowLobesKeepsItsFlux) {
    const Stage stage = floor_and_ceiling(0.01);
    const Light light = bulb(stage.light.position, 100.0);
    const Interreflection indirect = once(stage, {&light, 1});
    // A mirror: the ceiling sees the light at its image below the floor, if the floor is between.
    const Vec image{0.3, -0.2, -1.5};
    const DirectionalAlbedo albedo(core_material(stage.surfaces[0].material));
    constexpr int steps = 40;
    double found_lm = 0.0;
    double expected_lm = 0.0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const Vec at{(i + 0.5) * side_m / steps - 0.5 * side_m, (j + 0.5) * side_m / steps - 0.5 * side_m,
                         height_m};
            const Vec way = at - image;
            const double cosine = way.z / glm::length(way);
            const double area_m2 = side_m * side_m / (steps * steps);
            found_lm += area_m2 * indirect.on_surface(1, 0, at).x;
            expected_lm += area_m2 * albedo(cosine).x * 100.0 * cosine / glm::dot(way, way);
        }
    EXPECT_NEAR(found_lm / expected_lm, 1.0, 0.03);
}

// Many lights throw nothing, whatever each of them gives, so that their shares add up.
TEST(ThrownLight, OfManyLightsAddsUp) {
    const Stage stage = floor_and_ceiling(0.25);
    const Vec at{0.5, 0.2, height_m};
    for (const std::size_t count : {detail::most_throwing_lights, detail::most_throwing_lights + 1}) {
        std::vector<Light> lights;
        for (std::size_t i = 0; i < count; ++i)
            lights.push_back(bulb({0.3 * static_cast<double>(i) - 1.2, 0.1, 1.5}, i < 2 ? 100.0 : 0.0));
        const Vec together = once(stage, lights).on_surface(1, 0, at);
        Vec sum(0.0);
        for (const std::size_t lit : {0UL, 1UL}) {
            std::vector<Light> one = lights;
            one[1 - lit].intensity = Candelas(0.0);
            sum += once(stage, one).on_surface(1, 0, at);
        }
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(sum[channel] / together[channel], 1.0, 1e-5);
    }
}

TEST(ThrownLight, IsInTheBalanceOfAClosedStage) {
    Stage stage = test::stage_of(test::six_reflectances);
    stage.surfaces[4].material = GgxMaterial{Vec(0.8), 0.15};
    const Light light = bulb(test::six_reflectances.light, 100.0);
    LightingOptions options;
    options.bounces = all_bounces;
    const ExchangeBalance balance = Interreflection::of(stage, {&light, 1}, options).value().balance();
    const double emitted_lm = 400.0 * std::numbers::pi;
    EXPECT_NEAR((balance.absorbed_lm.x + balance.escaped_lm.x) / emitted_lm, 1.0, 1e-3);
}

} // namespace
} // namespace gonio
