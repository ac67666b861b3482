#include <gonio/preview/render.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/transport/intensity_pattern.hpp>
#include <gonio/transport/light_reach.hpp>
#include <gonio/transport/light_tree.hpp>

#include "../web/webs.hpp"
#include "numbers.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gonio {
namespace {

using test::Numbers;

LightDescription described(const char* shape, const char* intensity) {
    LightDescription description;
    description.shape = parse_shape(shape).value();
    description.intensity = parse_photometric_value(intensity).value();
    return description;
}

Light resolved(LightDescription description) {
    Diagnostics diagnostics;
    return resolve_light(std::move(description), diagnostics).value();
}

Web web_of(Symmetry symmetry, double first_gamma, double last_gamma, unsigned seed) {
    const auto gammas = [&] {
        // Not uniform, so that cells are searched.
        std::vector<double> angles = test::steps(first_gamma, last_gamma, 17);
        angles[3] += 0.37 * (angles[4] - angles[3]);
        return angles;
    }();
    switch (symmetry) {
    case Symmetry::axial:
        return test::random_web(symmetry, {0.0}, gammas, seed);
    case Symmetry::quadrant:
        return test::random_web(symmetry, test::steps(0, 90, 7), gammas, seed);
    case Symmetry::bilateral_0_180:
        return test::random_web(symmetry, {0.0, 10.0, 35.0, 90.0, 180.0}, gammas, seed);
    case Symmetry::bilateral_90_270:
        return test::random_web(symmetry, test::steps(90, 270, 13), gammas, seed);
    case Symmetry::none:
        break;
    }
    return test::random_web(symmetry, test::steps(0, 360, 25), gammas, seed);
}

LightDescription measured(Symmetry symmetry, double first_gamma, double last_gamma) {
    LightDescription description;
    description.shape =
        ProfileShape{"test.ies", std::make_shared<const Web>(web_of(symmetry, first_gamma, last_gamma, 5))};
    return description;
}

constexpr std::array symmetries{Symmetry::axial, Symmetry::quadrant, Symmetry::bilateral_0_180,
                                Symmetry::bilateral_90_270, Symmetry::none};

// Every kind of light once, some with ranges short enough not to reach everything.
std::vector<LightDescription> every_light() {
    std::vector<LightDescription> lights;
    for (const char* shape :
         {"point", "spot:outer=40deg,inner=10deg", "spot:outer=25deg,falloff=hard", "frustum:h=50deg,v=30deg",
          "sphere:r=20cm", "disk:r=30cm", "disk:r=30cm,two-sided", "ellipse:w=80cm,h=20cm", "rect:w=60cm,h=30cm",
          "tube:r=5cm,l=1m", "cylinder:r=5cm,l=1m"}) {
        lights.push_back(described(shape, "800lm"));
        lights.push_back(described(shape, "800lm"));
        lights.back().range = Meters(1.5);
    }
    for (const Symmetry symmetry : symmetries) {
        lights.push_back(measured(symmetry, 0.0, 70.0));
        lights.push_back(measured(symmetry, 95.0, 180.0));
    }
    for (const Photometry type : {Photometry::a, Photometry::b}) {
        lights.push_back(measured(Symmetry::none, 0.0, 70.0));
        std::get<ProfileShape>(lights.back().shape).web =
            std::make_shared<const Web>(Web::create(type, Symmetry::none, test::steps(-60, 40, 11),
                                                    test::steps(-30, 45, 6), std::vector<double>(66, 700.0))
                                            .value());
        lights.push_back(measured(Symmetry::none, 0.0, 70.0));
        std::vector<double> slopes;
        for (int i = 0; i < 35; ++i)
            slopes.push_back(10.0 * (i % 7) + 3.0 * i);
        std::get<ProfileShape>(lights.back().shape).web = std::make_shared<const Web>(
            Web::create(type, Symmetry::quadrant, test::steps(0, 80, 7), test::steps(0, 50, 5), slopes).value());
    }
    lights.push_back(described("disk:r=30cm", "800lm"));
    std::get<DiskShape>(lights.back().shape).mask = std::make_shared<const Web>(web_of(Symmetry::none, 0.0, 45.0, 6));
    lights.push_back(described("spot:outer=70deg", "800lm"));
    std::get<SpotShape>(lights.back().shape).mask = std::make_shared<const Web>(web_of(Symmetry::none, 20.0, 45.0, 7));
    return lights;
}

// The picture is the same to the last bit without skipping, for every light from several positions on every stage.
TEST(ThreadsSkipping, LeavesThePictureAsItIs) {
    RenderOptions options;
    options.width = 32;
    options.height = 24;
    std::vector<Light> all;
    for (const LightDescription& light : every_light())
        all.push_back(resolved(light));
    for (const StageKind& kind : stage_kinds()) {
        const Stage stage = make_stage(kind.name).value();
        Numbers numbers(3);
        for (Light& light : all)
            light.frame = aimed_frame(stage.light.position + numbers.in_box(0.9), numbers.direction(), {0.0, 1.0, 0.0});
        // Rendering without skipping is slow: each stage gets some of the lights, at random positions.
        const auto stage_index = static_cast<std::size_t>(&kind - stage_kinds().data());
        for (std::size_t first = stage_index % 4 * 5; first < all.size(); first += 20) {
            const std::span<const Light> lights =
                std::span(all).subspan(first, std::min<std::size_t>(5, all.size() - first));
            options.skip = true;
            const Rendering skipped = render(stage, lights, stage.camera, options).value();
            options.skip = false;
            const Rendering whole = render(stage, lights, stage.camera, options).value();
            EXPECT_EQ(skipped.luminance_nt.pixels, whole.luminance_nt.pixels) << kind.name << " from " << first;
            EXPECT_LT(skipped.stats.evaluated, whole.stats.evaluated) << kind.name << " from " << first;
            EXPECT_EQ(whole.stats.evaluated, whole.stats.evaluations);
            EXPECT_EQ(skipped.stats.evaluations, whole.stats.evaluations);
        }
    }
}

// Which counter counts what: a light at each position where it contributes nothing.
TEST(ThreadsSkipping, TellsWhy) {
    Stage stage;
    stage.surfaces.push_back({"floor", Plane{}, LambertMaterial{}});
    stage.camera = {{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 40.0};
    RenderOptions options;
    options.width = 40;
    options.height = 40;
    const std::size_t points = 1600;
    const auto stats_of = [&](LightDescription description, glm::dvec3 position, glm::dvec3 direction) {
        description.position = position;
        description.direction = direction;
        const Light light = resolved(description);
        return render(stage, {&light, 1}, stage.camera, options).value().stats;
    };
    const LightDescription point = described("point", "100cd");
    EXPECT_EQ(stats_of(point, {0, 0, 1}, {0, 0, -1}).evaluated, points);
    EXPECT_EQ(stats_of(point, {0, 0, -1}, {0, 0, -1}).below_horizon, points);
    LightDescription near = point;
    near.range = Meters(2.0);
    EXPECT_EQ(stats_of(near, {0, 9, 1}, {0, 0, -1}).out_of_range, points);
    EXPECT_EQ(stats_of(described("spot:outer=30deg", "100cd"), {0, 0, 1}, {0, 0, 1}).outside_cone, points);
    const RenderStats disk = stats_of(described("disk:r=10cm", "100cd"), {0, 0, 1}, {0, 0, 1}); // visible itself
    EXPECT_EQ(disk.outside_cone, disk.samples);
    EXPECT_EQ(stats_of(measured(Symmetry::none, 0.0, 60.0), {0, 0, 1}, {0, 0, 1}).outside_cone, points);
    const RenderStats dark = stats_of(described("point", "0cd"), {0, 0, 1}, {0, 0, -1});
    EXPECT_EQ(dark.dark, points);
    EXPECT_EQ(dark.dark_lights, 1U);
    EXPECT_EQ(dark.samples_without_specular, points);
    EXPECT_EQ(stats_of(measured(Symmetry::axial, 0.0, 60.0), {0, 0, 1}, {0, 0, 1}).axial_webs, 1U);
}

// A light that is reported to give nothing within bounds gives nothing to any point in them, by the probe in double.
TEST(Skipping, IsNeverWrongAboutWhoGetsNothing) {
    Numbers numbers(11);
    std::size_t skipped = 0;
    std::size_t lit = 0;
    for (const LightDescription& description : every_light()) {
        Light light = resolved(description);
        for (int trial = 0; trial < 400; ++trial) {
            light.frame = aimed_frame(numbers.in_box(1.0), numbers.direction(), numbers.direction());
            const detail::LightReach reach = detail::reach_of(light, true);
            // A patch of a plane or of a sphere.
            const glm::dvec3 at = numbers.in_box(2.0);
            const glm::dvec3 normal = numbers.direction();
            const double size = std::exp(numbers.between(-4.0, 0.0));
            const double bulge = trial % 2 == 0 ? 0.0 : numbers.between(0.0, 1.5);
            detail::BoundsBuilder bounds;
            std::vector<Receiver> receivers;
            for (int i = 0; i < 12; ++i) {
                glm::dvec3 off = numbers.in_box(1.0);
                off -= glm::dot(off, normal) * normal;
                receivers.push_back({at + size * off, bulge > 0.0 ? glm::normalize(normal + bulge * off) : normal});
                bounds.add(receivers.back().position, receivers.back().normal);
            }
            const bool none = reach.unlit(bounds.bounds()) != detail::Unlit::no;
            ProbeOptions options;
            options.method = IrradianceMethod::ltc; // takes masks from the centre, as pictures do
            options.threads = 1;
            const ProbeResult truth = probe(std::span(&light, 1), receivers, options).value();
            const double most = *std::max_element(truth.illuminance_lx.begin(), truth.illuminance_lx.end());
            if (none) {
                EXPECT_EQ(most, 0.0) << kind_of(light.shape) << " trial " << trial;
            }
            ++(none ? skipped : lit);
        }
    }
    EXPECT_GT(skipped, lit / 2); // the bounds are not so wide that they skip nothing
}

TEST(LightTree, FindsWhatASearchFinds) {
    Numbers numbers(17);
    for (const std::size_t count : {0UL, 1UL, 4UL, 5UL, 300UL}) {
        std::vector<detail::LightSphere> spheres;
        for (std::uint32_t i = 0; i < count; ++i)
            spheres.push_back({numbers.in_box(10.0), i % 50 == 7 ? INFINITY : numbers.between(0.0, 2.0), i});
        if (count == 300) // many at one position
            for (std::size_t i = 100; i < 200; ++i)
                spheres[i].center = spheres[100].center;
        const detail::LightTree tree(spheres);
        for (int trial = 0; trial < 200; ++trial) {
            const glm::dvec3 a = numbers.in_box(10.0);
            const glm::dvec3 b = a + numbers.in_box(3.0);
            const glm::dvec3 low = glm::min(a, b);
            const glm::dvec3 high = glm::max(a, b);
            detail::RayCone cone;
            cone.apex = numbers.in_box(12.0);
            cone.axis = numbers.direction();
            const double half_angle = numbers.between(0.0, 1.0);
            cone.sine = std::sin(half_angle);
            cone.cosine = std::cos(half_angle);
            std::vector<std::uint32_t> in_box;
            std::vector<std::uint32_t> in_cone;
            tree.meeting_box(low, high, in_box);
            tree.meeting_cone(cone, in_cone);
            std::sort(in_box.begin(), in_box.end());
            std::sort(in_cone.begin(), in_cone.end());
            std::vector<std::uint32_t> box_truth;
            std::vector<std::uint32_t> cone_truth;
            for (const detail::LightSphere& sphere : spheres) {
                const glm::dvec3 nearest = glm::clamp(sphere.center, low, high);
                if (glm::distance(nearest, sphere.center) <= sphere.radius) box_truth.push_back(sphere.light);
                if (cone.meets(sphere.center, sphere.radius)) cone_truth.push_back(sphere.light);
            }
            EXPECT_EQ(in_box, box_truth);
            EXPECT_EQ(in_cone, cone_truth);
        }
    }
}

// The greatest of values that fall with the distance, before planes of any direction, as a search over all finds it.
TEST(LightTree, NearLightsComeBeforeTheSearchEnds) {
    Numbers numbers(23);
    for (const std::size_t count : {0UL, 1UL, 5UL, 700UL}) {
        std::vector<detail::LightSphere> points;
        std::vector<double> strength;
        for (std::uint32_t i = 0; i < count; ++i) {
            points.push_back({numbers.in_box(10.0), 0.0, i});
            strength.push_back(numbers.between(0.0, 1.0));
        }
        const detail::LightTree tree(points);
        std::size_t visited = 0;
        constexpr int trials = 300;
        for (int trial = 0; trial < trials; ++trial) {
            const detail::LightTree::Before before{numbers.in_box(12.0), numbers.direction(), trial % 3 * 0.5};
            const double reach = numbers.between(0.0, 20.0);
            const auto value = [&](std::uint32_t light) {
                const glm::dvec3 to = points[light].center - before.place;
                const bool counts = glm::length(to) <= reach && glm::dot(to, before.normal) >= -before.margin;
                return counts ? strength[light] / glm::dot(to, to) : 0.0;
            };
            double truth = 0.0;
            for (std::uint32_t light = 0; light < count; ++light)
                truth = std::max(truth, value(light));
            double most = 0.0;
            tree.visit_near(before, reach, [&](std::uint32_t light) {
                ++visited;
                most = std::max(most, value(light));
                return most > 0.0 ? std::min(reach, 1.0 / std::sqrt(most)) : reach;
            });
            EXPECT_EQ(most, truth);
            int calls = 0;
            tree.visit_near(before, reach, [&](std::uint32_t /*light*/) {
                ++calls;
                return -1.0;
            });
            EXPECT_LE(calls, 1);
        }
        if (count == 700) {
            EXPECT_LT(visited, trials * count / 5);
        }
    }
}

// Points of a ray within the cone lie in spheres that the cone meets.
TEST(LightTree, AConeMeetsTheSpheresOfItsRays) {
    Numbers numbers(19);
    for (int trial = 0; trial < 2000; ++trial) {
        detail::RayCone cone;
        cone.apex = numbers.in_box(1.0);
        cone.axis = numbers.direction();
        const double half_angle = numbers.between(0.01, 1.2);
        cone.sine = std::sin(half_angle);
        cone.cosine = std::cos(half_angle);
        const glm::dvec3 across = glm::normalize(glm::cross(cone.axis, numbers.direction()));
        const double tilt = numbers.between(0.0, half_angle);
        const glm::dvec3 ray = std::cos(tilt) * cone.axis + std::sin(tilt) * across;
        const double radius = numbers.between(0.0, 2.0);
        const glm::dvec3 center = cone.apex + numbers.between(0.0, 9.0) * ray + radius * numbers.direction();
        EXPECT_TRUE(cone.meets(center, radius * (1.0 + 1e-12) + 1e-12));
    }
}

// Packed candela against the light's own, in double. Float angles are accurate to about 3e-5°, which changes a value by
// that much of its cell's slope; here cells are wider than 1° and candela stay below 1000.
TEST(IntensityPattern, IsTheLightsIntensity) {
    Numbers numbers(23);
    std::vector<LightDescription> kinds = every_light();
    for (const char* falloff :
         {"frostbite", "hard", "linear-cos", "smoothstep-cos", "linear-angle", "smoothstep-angle"})
        kinds.push_back(described((std::string("spot:outer=50deg,inner=20deg,falloff=") + falloff).c_str(), "500cd"));
    for (LightDescription& description : kinds) {
        description.position = numbers.in_box(50.0);
        description.direction = numbers.direction();
        const Light light = resolved(description);
        if (has_extent(light.shape)) continue;
        detail::WebTables tables;
        const detail::IntensityPattern pattern(light, tables);
        const glm::dvec3 anchor = description.position + numbers.in_box(3.0);
        constexpr std::size_t count = 501; // not a multiple of a packet
        std::array<std::vector<float>, 3> position;
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec3 at = numbers.in_box(3.0);
            for (int axis = 0; axis < 3; ++axis)
                position[static_cast<std::size_t>(axis)].push_back(static_cast<float>(at[axis]));
        }
        const transport::Points points{{position[0].data(), position[1].data(), position[2].data()}, count};
        for (const simd::InstructionSet set : simd::available_sets()) {
            std::vector<float> cd(count);
            pattern.evaluate(points, anchor, transport::intensity_kernels(set), cd.data());
            std::size_t outside = 0;
            for (std::size_t i = 0; i < count; ++i) {
                const glm::dvec3 at = anchor + glm::dvec3(position[0][i], position[1][i], position[2][i]);
                const double truth = light.intensity_towards(at - light.frame.origin).value;
                // A web that ends and a hard lobe drop to 0, and the rounding of an angle decides on which side.
                if ((truth == 0.0) != (cd[i] == 0.0F))
                    ++outside;
                else
                    EXPECT_NEAR(cd[i], truth, 1e-5 * truth + 0.05)
                        << kind_of(light.shape) << ' ' << simd::to_text(set) << " at " << i;
            }
            EXPECT_LE(outside, 1U) << kind_of(light.shape) << ' ' << simd::to_text(set);
        }
    }
}

} // namespace
} // namespace gonio
