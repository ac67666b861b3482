#include <gonio/light/light_color.hpp>
#include <gonio/scene/figure.hpp>
#include <gonio/transport/interreflection.hpp>

#include "../scaled.hpp"
#include "collocation.hpp"
#include "stages.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace gonio {
namespace {

using std::numbers::pi;
using test::BoxRoom;
using test::bulb;
using test::inwards;
using test::six_reflectances;
using test::stage_of;
using test::Vec;
using test::wall_points;
using test::WallPoint;

LightingOptions with_bounces(int bounces = all_bounces) {
    LightingOptions options;
    options.bounces = bounces;
    return options;
}

Interreflection solved(const Stage& stage, std::span<const Light> lights,
                       const LightingOptions& options = with_bounces()) {
    return Interreflection::of(stage, lights, options).value();
}

TEST(Collocation, AgreesWithNineThousandCells) {
    const test::ExtrapolatedCollocation truth(six_reflectances);
    for (const WallPoint& point : wall_points)
        EXPECT_NEAR(truth.indirect_lx(point.at, inwards(point.face)) / point.indirect_lx, 1.0, 3e-4);
}

// A point's own 8192 rays leave 0.1 %; between nodes, 0.5 % in a corner.
TEST(Interreflection, BoxOfSixReflectances) {
    const Light light = bulb(six_reflectances.light, six_reflectances.intensity_cd);
    const Interreflection indirect = solved(stage_of(six_reflectances), {&light, 1});
    for (const WallPoint& point : wall_points) {
        EXPECT_NEAR(indirect.at(point.at, inwards(point.face)).x / point.indirect_lx, 1.0, 1.5e-3);
        EXPECT_NEAR(indirect.on_surface(point.face, 0, point.at).x / point.indirect_lx, 1.0, 6e-3);
    }
}

// The last five have the light close to a ceiling, a corner or a wall, which is then much brighter than all else.
TEST(Interreflection, OtherBoxesAgreeWithCollocation) {
    const std::array rooms{BoxRoom{{2.0, 7.0, 2.4}, {0.7, 0.3, 0.5, 0.5, 0.1, 0.9}, {1.2, 5.0, 1.1}, 250.0},
                           BoxRoom{{8.0, 8.0, 3.5}, {0.5, 0.5, 0.05, 0.8, 0.3, 0.7}, {4.0, 4.0, 2.8}, 1000.0},
                           BoxRoom{{0.3, 0.4, 0.5}, {0.9, 0.8, 0.7, 0.9, 0.85, 0.9}, {0.1, 0.2, 0.3}, 1.0},
                           BoxRoom{{4.0, 4.0, 4.0}, {0.8, 0.1, 0.5, 0.3, 0.6, 0.7}, {2.0, 2.0, 3.8}, 100.0},
                           BoxRoom{{6.0, 3.0, 2.5}, {0.2, 0.7, 0.45, 0.6, 0.3, 0.8}, {0.5, 0.4, 2.2}, 300.0},
                           BoxRoom{{10.0, 6.0, 3.0}, {0.5, 0.4, 0.6, 0.3, 0.2, 0.75}, {9.0, 1.0, 0.5}, 500.0},
                           BoxRoom{{4.0, 3.0, 2.5}, {0.7, 0.5, 0.3, 0.6, 0.2, 0.8}, {0.15, 1.5, 1.2}, 100.0},
                           BoxRoom{{3.0, 5.0, 2.7}, {0.35, 0.65, 0.55, 0.15, 0.25, 0.85}, {2.7, 4.6, 2.4}, 100.0}};
    for (const BoxRoom& room : test::scaled(rooms)) {
        const test::ExtrapolatedCollocation truth(room);
        const Light light = bulb(room.light, room.intensity_cd);
        const Interreflection indirect = solved(stage_of(room), {&light, 1});
        for (std::size_t face = 0; face < 6; ++face)
            for (const Vec share : {Vec(0.5), Vec(0.3, 0.6, 0.25), Vec(0.7, 0.2, 0.8)}) {
                Vec at = share * room.size;
                const int axis = static_cast<int>(face / 2);
                at[axis] = face % 2 == 0 ? 0.0 : room.size[axis];
                const double lx = truth.indirect_lx(at, inwards(face));
                const auto where = [&] {
                    return testing::Message() << room.size.x << " m: " << face << ": " << share.x;
                };
                EXPECT_NEAR(indirect.at(at, inwards(face)).x / lx, 1.0, 3e-3) << where();
                EXPECT_NEAR(indirect.on_surface(face, 0, at).x / lx, 1.0, 1.5e-2) << where();
            }
    }
}

TEST(Interreflection, ClosedBoxOfOneReflectance) {
    BoxRoom room{{4.0, 3.0, 2.7}, {}, {2.0, 1.5, 1.3}, 1000.0 / (4.0 * pi)};
    room.albedo.fill(0.5);
    const Light light = bulb(room.light, room.intensity_cd);
    const ExchangeBalance balance = solved(stage_of(room), {&light, 1}).balance();
    const double area_m2 = 2.0 * (12.0 + 8.1 + 10.8);
    EXPECT_NEAR((balance.direct_lm.x + balance.indirect_lm.x) / area_m2 / 32.36245955, 1.0, 5e-4);
    EXPECT_NEAR(balance.absorbed_lm.x / 1000.0, 1.0, 5e-4);
}

// What is absorbed is what the light emits, wherever it is.
TEST(Interreflection, FluxBalancesInTheRoom) {
    const Stage stage = make_stage("room").value();
    const std::array places{Vec(0.0, 0.3, 2.3), Vec(-1.5, -2.0, 1.0), Vec(1.7, 2.2, 0.4), Vec(0.8, 0.6, 1.0)};
    for (const Vec& at : test::scaled(places)) {
        const Light light = bulb(at, 1000.0 / (4.0 * pi));
        const ExchangeBalance balance = solved(stage, {&light, 1}).balance();
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR((balance.absorbed_lm[channel] + balance.escaped_lm[channel]) / 1000.0, 1.0, 1e-3) << at.x;
    }
}

TEST(Interreflection, TwoInfinitePlanes) {
    const Stage stage = test::two_planes();
    const Light light = bulb({0.0, 0.0, 2.0}, 100.0);
    const Interreflection indirect = solved(stage, {&light, 1});
    for (const test::PlanesRow& row : test::planes_rows) {
        // Of the greatest value: far away, patches are as large as a tenth of the distance. On the surface it is
        // interpolated between nodes of 512 rays each, good for about 0.5 %.
        EXPECT_NEAR(indirect.at({row.r, 0.0, 0.0}, {0.0, 0.0, 1.0}).x, row.below_lx, 2.5e-3 * 9.25);
        EXPECT_NEAR(indirect.at({0.0, row.r, 3.0}, {0.0, 0.0, -1.0}).x, row.above_lx, 3e-3 * 3.34);
        EXPECT_NEAR(indirect.on_surface(0, 0, {row.r, 0.0, 0.0}).x, row.below_lx, 1e-2 * 9.25);
        EXPECT_NEAR(indirect.on_surface(1, 0, {0.0, row.r, 3.0}).x, row.above_lx, 1e-2 * 3.34);
    }
    const Interreflection once = solved(stage, {&light, 1}, with_bounces(1));
    EXPECT_NEAR(once.at(Vec(0.0), {0.0, 0.0, 1.0}).x / test::one_bounce_lx, 1.0, 2e-3);
}

// The sun above a black sphere: the lowest point sees the lit plane but for the round shadow below it.
TEST(Interreflection, SphereAboveASunlitPlane) {
    constexpr double radius = 0.5;
    constexpr double gap = 0.7;
    Stage stage;
    stage.camera = {{0.0, -3.0, 1.5}, {0.0, 0.0, 1.0}};
    stage.surfaces = {{"plane", Plane{Vec(0.0), Vec(0.0, 0.0, 1.0)}, LambertMaterial{Vec(0.4)}},
                      {"sphere", Ball{{0.0, 0.0, gap + radius}, radius}, LambertMaterial{Vec(0.0)}}};
    Light sun;
    sun.name = "sun";
    sun.shape = SunShape{Radians(1e-4)};
    sun.illuminance = Lux(1000.0);
    sun.luminance = Nits(1000.0 / (pi * 0.25e-8));
    sun.color = Vec(1.0);
    const Interreflection indirect = solved(stage, {&sun, 1});
    const double lowest_lx = 0.4 * 1000.0 * gap * gap / (radius * radius + gap * gap);
    EXPECT_NEAR(indirect.on_surface(1, 0, {0.0, 0.0, gap}).x / lowest_lx, 1.0, 1e-2);
    // Its equator sees half of the plane, less what the edge of the shadow takes; the top sees none of it.
    EXPECT_LT(indirect.on_surface(1, 0, {radius, 0.0, gap + radius}).x, 0.505 * 400.0);
    EXPECT_GT(indirect.on_surface(1, 0, {radius, 0.0, gap + radius}).x, 0.42 * 400.0);
    EXPECT_NEAR(indirect.on_surface(1, 0, {0.0, 0.0, gap + 2.0 * radius}).x, 0.0, 1e-6);
}

TEST(Interreflection, AddsUpOverLights) {
    if (test::is_sanitized) GTEST_SKIP() << "ScalesWhatIsKnownOfTheLights has several lights in this room";
    const Stage stage = make_stage("room").value();
    std::vector<Light> lights{bulb({0.0, 0.3, 2.3}, 100.0), bulb({1.0, -1.0, 1.0}, 30.0), bulb({-1.0, 2.0, 2.0}, 60.0)};
    lights[0].color = {1.6, 0.9, 0.2};
    lights[1].color = {0.5, 1.1, 1.9};
    const std::array points{Vec(0.5, -1.0, 0.0), Vec(-1.7, 2.0, 0.0), Vec(0.0, 0.0, 0.0)};
    const Interreflection all = solved(stage, lights);
    std::array<Vec, points.size()> sums{};          // of each while the others are dark
    std::array<Vec, points.size()> sums_of_alone{}; // which divides the stage elsewhere
    for (std::size_t i = 0; i < lights.size(); ++i) {
        std::vector<Light> one = lights;
        for (std::size_t other = 0; other < lights.size(); ++other)
            if (other != i) one[other].intensity = Candelas(0.0);
        const Interreflection lit = solved(stage, one);
        const Interreflection alone = solved(stage, {&lights[i], 1});
        for (std::size_t p = 0; p < points.size(); ++p) {
            sums[p] += lit.on_surface(0, 0, points[p]);
            sums_of_alone[p] += alone.on_surface(0, 0, points[p]);
        }
    }
    for (std::size_t p = 0; p < points.size(); ++p) {
        const Vec together = all.on_surface(0, 0, points[p]);
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(sums[p][channel] / together[channel], 1.0, 1e-5); // where the iteration stops
            EXPECT_NEAR(sums_of_alone[p][channel] / together[channel], 1.0, 2e-3);
        }
    }
}

TEST(Interreflection, TakesTheColourOfASurface) {
    BoxRoom room = six_reflectances;
    room.albedo.fill(0.5);
    Stage stage = stage_of(room);
    stage.surfaces[0].material = LambertMaterial{{0.8, 0.1, 0.1}};
    const Light light = bulb(room.light, 100.0);
    const Interreflection indirect = solved(stage, {&light, 1});
    const Vec beside = indirect.at({0.2, 2.0, 0.0}, {0.0, 0.0, 1.0});
    const Vec across = indirect.at({4.8, 2.0, 0.0}, {0.0, 0.0, 1.0});
    EXPECT_GT(beside.x / beside.y, 1.5);
    EXPECT_GT(beside.x / beside.y, across.x / across.y);
    EXPECT_DOUBLE_EQ(beside.y, beside.z);
}

// A room twice as large with four times the light is as bright.
TEST(Interreflection, ScalesWithTheRoom) {
    BoxRoom large = six_reflectances;
    large.size *= 2.0;
    large.light *= 2.0;
    large.intensity_cd *= 4.0;
    const Light light = bulb(six_reflectances.light, six_reflectances.intensity_cd);
    const Light brighter = bulb(large.light, large.intensity_cd);
    const Interreflection small_room = solved(stage_of(six_reflectances), {&light, 1});
    const Interreflection large_room = solved(stage_of(large), {&brighter, 1});
    for (const WallPoint& point : wall_points)
        EXPECT_NEAR(large_room.on_surface(point.face, 0, 2.0 * point.at).x /
                        small_room.on_surface(point.face, 0, point.at).x,
                    1.0, 1e-6); // floats of direct light
}

TEST(Interreflection, BouncesAddUp) {
    if (test::is_sanitized) GTEST_SKIP() << "TwoInfinitePlanes has one bounce, and all";
    const Light light = bulb(six_reflectances.light, six_reflectances.intensity_cd);
    const Stage stage = stage_of(six_reflectances);
    double last = 0.0;
    double last_step = 1e300;
    for (const int bounces : {1, 2, 3, 4, 8, 32}) {
        const double lx = solved(stage, {&light, 1}, with_bounces(bounces)).on_surface(4, 0, {2.5, 2.0, 0.0}).x;
        EXPECT_GT(lx, last);
        if (bounces <= 4) {
            EXPECT_LT(lx - last, last_step);
            last_step = lx - last;
        }
        last = lx;
    }
    // Only the sum of all is balanced, which corrects the level by what the rays of cells lost.
    EXPECT_NEAR(solved(stage, {&light, 1}).on_surface(4, 0, {2.5, 2.0, 0.0}).x / last, 1.0, 1.5e-3);
}

TEST(Interreflection, SameAtAnyNumberOfThreads) {
    const Stage stage = make_stage("corridor").value();
    const Light light = bulb({0.0, 4.0, 2.55}, 100.0);
    LightingOptions options = with_bounces();
    options.threads = 1;
    const Interreflection alone = solved(stage, {&light, 1}, options);
    options.threads = 3;
    const Interreflection shared = solved(stage, {&light, 1}, options);
    for (double y = -1.5; y < 16.0; y += 0.7)
        EXPECT_EQ(alone.on_surface(0, 0, {0.3, y, 0.0}), shared.on_surface(0, 0, {0.3, y, 0.0}));
}

// Light is linear: of lights that all changed by one factor, everything follows.
TEST(Interreflection, ScalesWhatIsKnownOfTheLights) {
    const Stage stage = make_stage("room").value();
    std::vector<Light> lights{bulb({0.0, 0.3, 2.3}, 100.0), bulb({1.0, -1.0, 1.0}, 30.0)};
    const Interreflection first = solved(stage, lights);
    for (Light& light : lights) {
        light.intensity.value *= 3.0;
        light.color = {1.6, 0.9, 0.2};
    }
    const auto expect_near = [](const Vec& found, const Vec& expected) {
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(found[channel] / expected[channel], 1.0, 1e-5); // where the iteration stops
    };
    const auto compare = [&] {
        const Interreflection fresh = solved(stage, lights);
        const Interreflection again = Interreflection::of(stage, lights, with_bounces(), {}, &first).value();
        for (const double y : {-1.0, 0.5, 2.0}) {
            expect_near(again.on_surface(0, 0, {1.7, y, 0.0}), fresh.on_surface(0, 0, {1.7, y, 0.0}));
            expect_near(again.at({-1.7, y, 0.7}, {0.0, 0.0, 1.0}), fresh.at({-1.7, y, 0.7}, {0.0, 0.0, 1.0}));
        }
        expect_near(again.balance().absorbed_lm, fresh.balance().absorbed_lm);
    };
    compare();
    lights[1].intensity.value *= 2.0; // not a factor of both
    compare();
}

TEST(Interreflection, UsesWhatIsKnownOfTheStage) {
    Stage stage = make_stage("room").value();
    const Light light = bulb({0.0, 0.3, 2.3}, 100.0);
    const Interreflection first = solved(stage, {&light, 1});
    stage.surfaces[1].material = LambertMaterial{Vec(0.3)};
    const Interreflection fresh = solved(stage, {&light, 1});
    const Interreflection again = Interreflection::of(stage, {&light, 1}, with_bounces(), {}, &first).value();
    EXPECT_EQ(again.on_surface(0, 0, {1.0, -1.0, 0.0}), fresh.on_surface(0, 0, {1.0, -1.0, 0.0}));
    // Of another stage nothing is used.
    const Stage other = make_stage("corridor").value();
    EXPECT_EQ(Interreflection::of(other, {&light, 1}, with_bounces(), {}, &first).value().node_count(),
              solved(other, {&light, 1}).node_count());
}

// Fifteen limbs close together would be most of the work, and what they reflect changes little around them.
TEST(Interreflection, DividesAScaleFigureCoarsely) {
    const Stage alone = make_stage("room").value();
    Stage coarse = alone;
    add_figure(coarse);
    Stage fine = coarse;
    for (Surface& surface : fine.surfaces)
        surface.subject = true;
    const Light light = bulb({0.0, 0.3, 2.3}, 100.0);
    const ExchangeQuality quick{.patches = 2000.0, .cell_rays = 64, .node_rays = 128};
    const auto solve = [&](const Stage& stage) {
        return Interreflection::of(stage, {&light, 1}, with_bounces(), quick).value();
    };
    const Interreflection with_figure = solve(coarse);
    EXPECT_LT(with_figure.nodes_lx().size(), 2 * solve(alone).nodes_lx().size());
    if (test::is_sanitized) return; // the fine figure is most of the work, and only to compare with
    const Interreflection exact = solve(fine);
    EXPECT_GT(exact.nodes_lx().size(), with_figure.nodes_lx().size());
    for (const double z : {0.05, 0.9, 1.8}) {
        const Vec beside = coarse.figure_position + Vec(0.4, -0.4, z);
        const Vec found = with_figure.at(beside, {0.0, 0.0, 1.0});
        EXPECT_NEAR(found.y / exact.at(beside, {0.0, 0.0, 1.0}).y, 1.0, 0.005) << z;
    }
}

// A disk of 1000 lm where a stage has its light, over matte surfaces.
Interreflection under_its_lamp(Stage stage, double patches) {
    for (Surface& surface : stage.surfaces)
        surface.material = LambertMaterial{hemispherical_albedo(surface.material)};
    LightDescription lamp;
    lamp.shape = parse_shape("disk:r=15cm").value();
    lamp.intensity = {1000.0, parse_photometric_unit("lm").value()};
    hang(lamp, stage.light);
    Diagnostics ignored;
    const Light light = resolve_light(std::move(lamp), ignored).value();
    ExchangeQuality quality;
    quality.patches = patches;
    quality.receiver_rays = 16384;
    return Interreflection::of(stage, {&light, 1}, with_bounces(), quality).value();
}

// The kerb is 12 cm high, and what it sends to the road beside it falls to a half within 7 cm. Along it the light falls
// to a tenth from the lamp's foot to the end. Nodes in the joint of both took their light from the ends of a strip ten
// metres long, and were 60 % too bright. The points' own rays are the truth here, and leave some 3 %.
TEST(Interreflection, FollowsALowKerb) {
    if (test::is_sanitized) GTEST_SKIP() << "SeesPartsOfABrightPool is solved in the same way";
    const Interreflection indirect = under_its_lamp(make_stage("street").value(), 8000.0);
    double square = 0.0;
    int count = 0;
    for (const double beside : {0.001, 0.03, 0.09})
        for (double x = -10.0; x <= 12.5; x += 1.5) {
            const Vec road(x, beside, 0.0);
            const double from_nodes = indirect.on_surface(0, 0, road).y;
            const double from_rays = indirect.at(road + Vec(0.0, 0.0, 1e-6), {0.0, 0.0, 1.0}).y;
            EXPECT_NEAR(from_nodes / from_rays, 1.0, 0.12) << x << ' ' << beside;
            square += (from_nodes / from_rays - 1.0) * (from_nodes / from_rays - 1.0);
            ++count;
        }
    EXPECT_LT(std::sqrt(square / count), 0.05);
}

// A card sees the pool of light on the floor past a card and its stand, which hide a part of each cell of it. With one
// ray to each cell the card was 1 % off, this way or that by where the cells lay.
TEST(Interreflection, SeesPartsOfABrightPool) {
    const Vec card(-0.045, 2.0 - 1e-6, 1.353);
    constexpr double by_paths_lx = 0.7853; // of gonio-indirect-truth-table, 64000 in each half
    constexpr std::array patches_of_runs{4000.0, 8000.0, 16000.0};
    for (const double patches : test::scaled(patches_of_runs))
        EXPECT_NEAR(under_its_lamp(make_stage("card").value(), patches).at(card, {0.0, -1.0, 0.0}).y / by_paths_lx, 1.0,
                    0.005)
            << patches;
}

TEST(Interreflection, RefusesALightThatCannotLeave) {
    BoxRoom room = six_reflectances;
    room.albedo.fill(1.0);
    const Light light = bulb(room.light, 100.0);
    const auto refused = Interreflection::of(stage_of(room), {&light, 1}, with_bounces());
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().diagnostics.back().message.find("reflect all light"), std::string::npos);
    EXPECT_TRUE(Interreflection::of(stage_of(room), {&light, 1}, with_bounces(3)));
    room.albedo[4] = 0.9; // one surface that absorbs is enough
    const Interreflection bright = solved(stage_of(room), {&light, 1});
    EXPECT_NEAR(bright.balance().absorbed_lm.x / (400.0 * pi), 1.0, 5e-3);
}

// Stages without anything, without light, with coincident surfaces, or with a light inside a solid.
TEST(Interreflection, StaysFiniteOnHostileStages) {
    const Light light = bulb({1.5, 1.0, 2.2}, 100.0);
    const auto finite = [](const Interreflection& indirect, const Vec& at) {
        const Vec lx = indirect.at(at, {0.0, 0.0, 1.0});
        EXPECT_TRUE(std::isfinite(lx.x) && lx.x >= 0.0) << lx.x;
    };
    finite(solved(Stage(), {&light, 1}), Vec(0.0));
    finite(solved(make_stage("room").value(), {}), Vec(0.0));
    Stage twice = stage_of(six_reflectances);
    const std::vector<Surface> once = twice.surfaces;
    twice.surfaces.insert(twice.surfaces.end(), once.begin(), once.end());
    finite(solved(twice, {&light, 1}), {2.0, 2.0, 1.0});
    Stage boxed = stage_of(six_reflectances);
    boxed.surfaces.push_back({"box", Box{{{1.5, 1.0, 2.2}}, Vec(0.3)}, LambertMaterial{Vec(0.5)}});
    finite(solved(boxed, {&light, 1}), {2.0, 2.0, 1.0});
    Stage thin;
    thin.surfaces = {{"sheet", panel_facing(Vec(0.0), {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, 1e-9, 3.0), LambertMaterial{}},
                     {"sphere", Ball{Vec(0.0, 0.0, 1e-9), 1e-9}, LambertMaterial{}}};
    finite(solved(thin, {&light, 1}), {0.0, 0.0, 1.0});
}

} // namespace
} // namespace gonio
