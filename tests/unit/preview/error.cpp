// RenderOptions::error: pictures with it against pictures without.
#include <gonio/light/light.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/stage.hpp>

#include "../light/luminaire.hpp"
#include "../scaled.hpp"
#include "numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace gonio {
namespace {

// Luminaires over a square, of several profiles and openings, aimed within 20° of the nadir.
std::vector<Light> luminaires(std::size_t count, double side_m) {
    constexpr std::array formulas{"cosine:power=3", "batwing", "wall-washer", "cosine:power=1,up=0.3"};
    constexpr std::array openings{"rect:w=40cm,h=20cm", "disk:r=15cm", "ellipse:w=60cm,h=20cm",
                                  "box:w=30cm,h=30cm,d=10cm"};
    std::vector<std::shared_ptr<const Web>> webs;
    for (const char* const formula : formulas)
        webs.push_back(test::authored_web(formula));
    std::vector<std::shared_ptr<const Opening>> given;
    for (const char* const opening : openings)
        given.push_back(std::make_shared<const Opening>(parse_opening(opening).value()));
    OpeningBodies bodies; // shared, as in a rig
    for (const auto& web : webs)
        for (const auto& opening : given)
            bodies[{web.get(), opening.get()}] = opening_body(*opening, *web);
    test::Numbers numbers(4);
    std::vector<Light> lights;
    for (std::size_t i = 0; i < count; ++i) {
        LightDescription description;
        description.name = "light " + std::to_string(i);
        ProfileShape shape;
        shape.file = "made.ies";
        shape.web = webs.at(i % webs.size());
        shape.size = ProfileSize::opening;
        shape.given = given.at(i / webs.size() % given.size());
        description.shape = std::move(shape);
        description.position = {numbers.between(-0.5, 0.5) * side_m, numbers.between(-0.5, 0.5) * side_m,
                                numbers.between(3.0, 6.0)};
        description.direction = {numbers.between(-0.2, 0.2), numbers.between(-0.2, 0.2), -1.0};
        if (i % 3 == 0) description.range = Meters(numbers.between(10.0, 30.0));
        Diagnostics ignored;
        lights.push_back(resolve_light(std::move(description), ignored, bodies).value());
    }
    return lights;
}

// A glossy ground, a matte wall and, maybe, a box in the light.
Stage square(double side_m, bool has_box) {
    Stage stage;
    stage.surfaces.push_back({"ground", Plane{}, parse_material("frostbite:base=0.4,smoothness=0.5").value()});
    stage.surfaces.push_back(
        {"wall", Plane{{0.0, 0.4 * side_m, 0.0}, {0.0, -1.0, 0.0}}, LambertMaterial{glm::dvec3(0.6, 0.5, 0.4)}});
    const Box box{{{2.0, -3.0, 1.0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {1.5, 1.0, 1.0}};
    if (has_box) stage.surfaces.push_back({"box", box, parse_material("ggx:f0=0.8,alpha=0.4").value()});
    stage.camera = {{0.0, -0.7 * side_m, 0.3 * side_m}, {0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 50.0, 50.0};
    return stage;
}

double greatest_difference(const Image& with, const Image& without) {
    double most = 0.0;
    for (std::size_t i = 0; i < without.pixels.size(); ++i)
        if (without.pixels[i] > 0.0F)
            most =
                std::max(most, std::abs(static_cast<double>(with.pixels[i]) - static_cast<double>(without.pixels[i])) /
                                   static_cast<double>(without.pixels[i]));
        else
            EXPECT_EQ(with.pixels[i], 0.0F);
    return most;
}

// Evaluations that are not those of pictures without an error.
std::size_t seen_otherwise(const RenderStats& stats) {
    return stats.from_center + stats.as_point;
}

TEST(PictureError, StaysWithinWhatIsAskedFor) {
    struct Rig {
        std::size_t lights;
        double side_m;
        bool has_box; // light that it may stop is not seen from its centre
    };
    for (const Rig& rig : {Rig{2, 30.0, false}, Rig{20, 40.0, true}, Rig{300, 200.0, false}}) {
        if (test::is_sanitized && rig.lights > 20) continue;
        const std::vector<Light> lights = luminaires(rig.lights, rig.side_m);
        const Stage stage = square(rig.side_m, rig.has_box);
        RenderOptions options;
        options.width = 64;
        options.height = 48;
        options.illuminance = true;
        const Rendering exact = render(stage, lights, stage.camera, options).value();
        EXPECT_EQ(seen_otherwise(exact.stats), 0U);
        std::size_t before = 0;
        for (const double error : {0.001, 0.01, 0.05}) {
            options.error = error;
            const Rendering near = render(stage, lights, stage.camera, options).value();
            EXPECT_LE(greatest_difference(near.luminance_nt, exact.luminance_nt), error) << rig.lights;
            EXPECT_LE(greatest_difference(near.illuminance_lx, exact.illuminance_lx), error) << rig.lights;
            EXPECT_LE(near.stats.evaluated, exact.stats.evaluated); // webs that are dark towards a chunk are left out
            EXPECT_GE(seen_otherwise(near.stats), before) << rig.lights << " at " << error;
            before = seen_otherwise(near.stats);
        }
        if (rig.lights == 2) continue; // each has all of the light somewhere
        EXPECT_GT(before, 0U) << rig.lights;
        if (rig.has_box) continue;
        EXPECT_GT(before, exact.stats.evaluated / 2); // it is of use
    }
}

TEST(PictureError, IsTheSameWithAnyNumberOfThreads) {
    const std::vector<Light> lights = luminaires(40, 60.0);
    const Stage stage = square(60.0, false);
    RenderOptions options;
    options.width = 96;
    options.height = 64;
    options.error = 0.01;
    options.threads = 1;
    const Rendering one = render(stage, lights, stage.camera, options).value();
    options.threads = 3;
    const Rendering three = render(stage, lights, stage.camera, options).value();
    EXPECT_GT(one.stats.as_point, 0U);
    EXPECT_EQ(one.luminance_nt.pixels, three.luminance_nt.pixels);
}

// Nothing changes where there is nothing to see from its centre.
TEST(PictureError, LeavesOtherLightsAsTheyAre) {
    std::vector<Light> lights;
    for (const char* const shape : {"point", "spot:outer=40deg", "sphere:r=10cm", "rect:w=60cm,h=30cm"}) {
        LightDescription description;
        description.shape = parse_shape(shape).value();
        description.intensity = parse_photometric_value("800lm").value();
        description.position = {0.0, static_cast<double>(lights.size()), 4.0};
        Diagnostics ignored;
        lights.push_back(resolve_light(std::move(description), ignored).value());
    }
    const Stage stage = square(20.0, false);
    RenderOptions options;
    options.width = 48;
    options.height = 32;
    const Rendering without = render(stage, lights, stage.camera, options).value();
    options.error = 0.05;
    const Rendering with = render(stage, lights, stage.camera, options).value();
    EXPECT_EQ(seen_otherwise(with.stats), 0U);
    EXPECT_EQ(with.luminance_nt.pixels, without.luminance_nt.pixels);
}

} // namespace
} // namespace gonio
