// The bound of an opening as a point at its centre, against the light of the opening.
#include <gonio/scene/material.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/transport/lit_scene.hpp>
#include <gonio/transport/point_form.hpp>
#include <gonio/transport/sample_shader.hpp>

#include "../light/luminaire.hpp"
#include "../preview/numbers.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gonio {
namespace {

using detail::LitLight;
using detail::LitScene;
using detail::LobeVariation;
using detail::PointForm;
using detail::SampleShader;
using detail::SurfaceSamples;
using detail::ViewBounds;
using test::Numbers;

// Points of a floor, or of something round that bulges from it, about the origin, seen from one place.
SurfaceSamples patch(Numbers& numbers, double radius_m, double curvature) {
    SurfaceSamples samples;
    const glm::dvec3 eye = 60.0 * glm::normalize(numbers.direction() * glm::dvec3(1.0, 1.0, 0.0) +
                                                 glm::dvec3(0.0, 0.0, numbers.between(0.15, 2.0)));
    for (std::uint32_t i = 0; i < 16; ++i) {
        const glm::dvec3 at(numbers.between(-radius_m, radius_m), numbers.between(-radius_m, radius_m), 0.0);
        const glm::dvec3 normal = glm::normalize(glm::dvec3(0.0, 0.0, 1.0) + curvature * at);
        samples.add({at, normal, glm::normalize(eye - at)}, i, 1.0, -1);
    }
    samples.finish_chunk();
    return samples;
}

Stage stage_of(const Material& material) {
    Stage stage;
    stage.surfaces.push_back({"floor", Plane{}, material});
    return stage;
}

struct Greatest {
    double of_bound = 0.0; // difference over its bound
    double bound = 0.0;    // over the light
    std::size_t bounded = 0;
    std::size_t all = 0;
};

// Random luminaires of one formula over random points. `rounding`: what else they may differ by, over the light.
Greatest compare(const std::string& formula, const Material& material, IrradianceMethod truth, double rounding,
                 std::size_t poses) {
    constexpr std::array openings{"rect:w=40cm,h=20cm", "disk:r=15cm", "ellipse:w=60cm,h=20cm"};
    Numbers numbers(11);
    Greatest greatest;
    const auto web = test::authored_web(formula);
    const Stage stage = stage_of(material);
    for (std::size_t pose = 0; pose < poses; ++pose) {
        LightDescription description;
        ProfileShape shape;
        shape.file = "made.ies";
        shape.web = web;
        shape.size = ProfileSize::opening;
        shape.given = std::make_shared<const Opening>(parse_opening(openings.at(pose % openings.size())).value());
        description.shape = std::move(shape);
        const double away_m = numbers.between(0.0, 30.0);
        const double turn = numbers.between(0.0, 6.28);
        description.position = {away_m * std::cos(turn), away_m * std::sin(turn), numbers.between(2.0, 12.0)};
        description.direction = {numbers.between(-0.4, 0.4), numbers.between(-0.4, 0.4), -1.0};
        Diagnostics ignored;
        const std::vector<Light> lights{resolve_light(std::move(description), ignored).value()};
        const SurfaceSamples samples =
            patch(numbers, numbers.between(0.02, 2.0), pose % 3 == 0 ? numbers.between(0.0, 0.2) : 0.0);
        LightingOptions options;
        options.illuminance = true;
        const LitScene scene(stage, lights, options);
        LightingOptions exactly = options;
        exactly.method = truth;
        const LitScene true_scene(stage, lights, exactly);
        const LobeVariation lobe = LobeVariation::of(scene.core_materials[0]).value();
        const ViewBounds views(samples, 0, samples.size());
        for (std::size_t face = 0; face < scene.lights.size(); ++face) {
            const LitLight& lit = scene.lights[face];
            const PointForm form = point_form(lit, samples.chunks[0].bounds, views, lobe);
            greatest.all += samples.size();
            if (!form.is_bounded()) continue;
            greatest.bounded += samples.size();
            SampleShader as_point(scene);
            as_point.shade_as_point(lit, std::array{form}, samples.size(), samples, 0, samples.size());
            SampleShader as_it_is(true_scene);
            as_it_is.shade(true_scene.lights[face], samples, 0, samples.size(), samples.share.data());
            const auto look = [&](float value, float error, float wanted) {
                const double off = std::abs(static_cast<double>(value) - static_cast<double>(wanted));
                const double excess = off - rounding * static_cast<double>(wanted);
                EXPECT_LE(excess, static_cast<double>(error)) << formula << ", pose " << pose;
                if (!(error > 0.0F)) return;
                greatest.of_bound = std::max(greatest.of_bound, excess / static_cast<double>(error));
                greatest.bound = std::max(greatest.bound, static_cast<double>(error) / static_cast<double>(value));
            };
            for (std::size_t i = 0; i < samples.size(); ++i) {
                look(as_point.lx()[i], as_point.lx_error()[i], as_it_is.lx()[i]);
                for (std::size_t channel = 0; channel < 3; ++channel)
                    look(as_point.rgb()[channel][i], as_point.rgb_error()[channel][i], as_it_is.rgb()[channel][i]);
            }
        }
    }
    return greatest;
}

// Against the integral over the elements of the opening.
TEST(PointForm, BoundsTheLightOfOpeningsOnMatteSurfaces) {
    for (const char* const formula :
         {"cosine:power=3", "cosine:power=1", "batwing", "wall-washer", "cosine:power=1,up=0.3"}) {
        const Greatest greatest =
            compare(formula, LambertMaterial{glm::dvec3(0.6, 0.5, 0.4)}, IrradianceMethod::reference, 3e-6, 24);
        EXPECT_GT(greatest.bounded, greatest.all / 4) << formula;
        EXPECT_GT(greatest.of_bound, 0.02) << formula; // it is of the right order
        std::cout << formula << ": at most " << greatest.of_bound << " of the bound\n";
    }
}

// With the same luminance in all directions columns are exact, so what is left is the shape: against the closed forms
// and the lobe's own rule.
TEST(PointForm, BoundsTheShapeUnderLobes) {
    for (const char* const material : {"frostbite:base=0.4,smoothness=0.2", "frostbite:base=0.4,smoothness=0.45",
                                       "ggx:f0=0.8,alpha=0.4", "ggx:f0=0.04,alpha=0.15"}) {
        const Greatest greatest =
            compare("cosine:power=1", parse_material(material).value(), IrradianceMethod::exact, 3e-4, 80);
        EXPECT_GT(greatest.bounded, greatest.all / 8) << material;
        EXPECT_GT(greatest.of_bound, 0.005) << material;
        std::cout << material << ": at most " << greatest.of_bound << " of the bound\n";
    }
}

TEST(PointForm, HasNoBoundForOtherMaterials) {
    for (const char* const material : {"eon:roughness=0.5", "gltf:base=0.5,roughness=0.5", "blinn"}) {
        const Result<Material> parsed = parse_material(material);
        if (!parsed) continue;
        const Stage stage = stage_of(*parsed);
        const std::vector<Light> lights{test::luminaire("batwing", "disk:r=15cm")};
        const LightingOptions options;
        const LitScene scene(stage, lights, options);
        EXPECT_FALSE(LobeVariation::of(scene.core_materials[0])) << material;
    }
}

} // namespace
} // namespace gonio
