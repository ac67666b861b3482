// Indirect light from what rays would miss or draw edges of, against the sum over its points.
#include <gonio/scene/primitives.hpp>
#include <gonio/transport/interreflection.hpp>

#include "stages.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace gonio {
namespace {

using test::bulb;
using test::Vec;

constexpr Vec up{0.0, 0.0, 1.0};

// A part of a surface as a point.
struct Spot {
    Vec position, normal;
    double area_m2;
};

// Of the light of a bulb that the spots reflect once.
double reflected_lx(const std::vector<Spot>& spots, double albedo, const Light& light, const Vec& at,
                    const Vec& normal) {
    double lx = 0.0;
    for (const Spot& spot : spots) {
        const Vec to_light = light.frame.origin - spot.position;
        const Vec away = at - spot.position;
        const double light2 = glm::dot(to_light, to_light);
        const double away2 = glm::dot(away, away);
        const double lit = std::max(glm::dot(spot.normal, to_light), 0.0) / (light2 * std::sqrt(light2));
        const double seen = std::max(glm::dot(spot.normal, away), 0.0) * std::max(-glm::dot(normal, away), 0.0);
        lx += light.intensity.value * lit * albedo / std::numbers::pi * seen * spot.area_m2 / (away2 * away2);
    }
    return lx;
}

std::vector<Spot> spots_of(const Panel& panel, int along) {
    std::vector<Spot> spots;
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < along; ++j)
            spots.push_back({panel.frame.origin + ((i + 0.5) / along - 0.5) * panel.width * panel.frame.x +
                                 ((j + 0.5) / along - 0.5) * panel.height * panel.frame.y,
                             panel.frame.z, panel.width * panel.height / (along * along)});
    return spots;
}

std::vector<Spot> spots_of_upright(const Capsule& capsule, int around, int along) {
    std::vector<Spot> spots;
    const double length = 2.0 * capsule.half_length;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < along; ++j) {
            const double azimuth = 2.0 * std::numbers::pi * (i + 0.5) / around;
            const Vec normal(std::cos(azimuth), std::sin(azimuth), 0.0);
            spots.push_back({capsule.center + capsule.radius * normal + ((j + 0.5) / along - 0.5) * length * up, normal,
                             2.0 * std::numbers::pi * capsule.radius * length / (around * along)});
        }
    return spots;
}

std::vector<Spot> spots_of(const Ball& ball, int around) {
    std::vector<Spot> spots;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < around; ++j) {
            const double z = 2.0 * (j + 0.5) / around - 1.0;
            const double azimuth = 2.0 * std::numbers::pi * (i + 0.5) / around;
            const double r = std::sqrt(1.0 - z * z);
            const Vec normal(r * std::cos(azimuth), r * std::sin(azimuth), z);
            spots.push_back({ball.center + ball.radius * normal, normal,
                             4.0 * std::numbers::pi * ball.radius * ball.radius / (around * around)});
        }
    return spots;
}

// On an endless black floor that the camera sees some metres of.
Stage stage_with(const Primitive& thing, double albedo) {
    Stage stage;
    stage.camera = {{0.0, -6.0, 2.0}, {0.0, 0.0, 1.0}};
    stage.light.position = {0.0, 0.0, 1.2};
    stage.surfaces = {{"floor", Plane{Vec(0.0), up}, LambertMaterial{Vec(0.0)}},
                      {"thing", thing, LambertMaterial{Vec(albedo)}}};
    return stage;
}

Interreflection once(const Stage& stage, const Light& light) {
    LightingOptions options;
    options.bounces = 1;
    return Interreflection::of(stage, {&light, 1}, options).value();
}

// A card of 20 cm, from a quarter of its side away to some metres.
TEST(Links, OfASmallCard) {
    constexpr double albedo = 0.5;
    const Panel card = panel_facing({0.0, 1.0, 0.5}, {0.0, -1.0, 0.0}, up, 0.2, 0.2);
    const Light light = bulb({0.1, 0.5, 0.8}, 100.0);
    const Interreflection indirect = once(stage_with(card, albedo), light);
    const std::vector<Spot> spots = spots_of(card, 200);
    for (const Vec& at : {Vec(0.0, 0.8, 0.0), Vec(0.5, -0.4, 0.0), Vec(-1.0, -2.0, 0.0), Vec(0.3, -4.0, 0.0)}) {
        const double expected = reflected_lx(spots, albedo, light, at, up);
        EXPECT_NEAR(indirect.on_surface(0, 0, at).x / expected, 1.0, 0.07) << at.x << ' ' << at.y;
        EXPECT_NEAR(indirect.at(at, up).x / expected, 1.0, 0.01) << at.x << ' ' << at.y;
    }
    // Just above the card, whose light changes within it.
    for (const Vec& at : {Vec(0.0, 0.95, 0.45), Vec(0.08, 0.95, 0.55)}) {
        const Vec towards(0.0, 1.0, 0.0);
        const double expected = reflected_lx(spots, albedo, light, at, towards);
        EXPECT_NEAR(indirect.at(at, towards).x / expected, 1.0, 0.01) << at.x << ' ' << at.z;
    }
}

// A pole of 2 cm, closer to it than its patches are long.
TEST(Links, OfAThinPole) {
    constexpr double albedo = 0.5;
    const Capsule pole = capsule_between({0.0, 1.0, 0.2}, {0.0, 1.0, 2.2}, 0.01);
    const Light light = bulb({0.3, 0.2, 1.2}, 100.0);
    const Interreflection indirect = once(stage_with(pole, albedo), light);
    const std::vector<Spot> spots = spots_of_upright(pole, 90, 2000);
    for (const Vec& at : {Vec(0.1, 0.7, 0.0), Vec(0.0, 0.4, 0.0), Vec(-0.5, -0.5, 0.0), Vec(1.0, -3.0, 0.0)}) {
        const double expected = reflected_lx(spots, albedo, light, at, up);
        EXPECT_NEAR(indirect.at(at, up).x / expected, 1.0, 0.015) << at.x << ' ' << at.y;
    }
}

// A ball, linked by its patches where it is close and by groups of its cells where it is far.
TEST(Links, OfASmallBall) {
    constexpr double albedo = 0.5;
    const Ball ball{{0.0, 1.0, 0.5}, 0.15};
    const Light light = bulb({0.5, 0.5, 0.9}, 100.0);
    const Interreflection indirect = once(stage_with(ball, albedo), light);
    const std::vector<Spot> spots = spots_of(ball, 400);
    for (const Vec& at :
         {Vec(0.0, 0.8, 0.0), Vec(0.5, 0.4, 0.0), Vec(0.5, -0.4, 0.0), Vec(1.0, -2.0, 0.0), Vec(2.0, -3.0, 0.0)}) {
        const double expected = reflected_lx(spots, albedo, light, at, up);
        EXPECT_NEAR(indirect.at(at, up).x / expected, 1.0, 0.02) << at.x << ' ' << at.y;
    }
}

// What a light close to a wall makes bright there: patches are coarse beside the distance of a receiver, so what
// links carry has slopes within each.
TEST(Links, OfAWallCloseToALight) {
    constexpr double albedo = 0.6;
    const Panel wall = panel_facing({0.0, 0.5, 1.5}, {0.0, -1.0, 0.0}, up, 6.0, 3.0);
    const Light light = bulb({0.0, 0.1, 1.6}, 100.0);
    const Interreflection indirect = once(stage_with(wall, albedo), light);
    const std::vector<Spot> spots = spots_of(wall, 1000);
    for (const Vec& at : {Vec(0.0, 0.3, 1.2), Vec(0.2, 0.2, 2.2), Vec(-0.6, 0.0, 1.6), Vec(0.0, -2.0, 1.0)})
        for (const Vec& normal : {up, -up, Vec(0.0, 1.0, 0.0)}) {
            const double towards = reflected_lx(spots, albedo, light, at, {0.0, 1.0, 0.0});
            const double expected = reflected_lx(spots, albedo, light, at, normal);
            EXPECT_NEAR(indirect.at(at, normal).x, expected, 0.01 * std::max(expected, 0.5 * towards))
                << at.x << ' ' << at.y << ' ' << normal.z;
        }
}

} // namespace
} // namespace gonio
