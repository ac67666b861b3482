#include <gonio/scene/core_vector.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/transport/exchange_geometry.hpp>
#include <gonio/transport/interreflection.hpp>
#include <gonio/transport/lit_scene.hpp>
#include <gonio/transport/lobe_rays.hpp>
#include <gonio/transport/reflected_view.hpp>

#include "../light/lights.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace gonio::detail {
namespace {

// Points of the floor before the box of `room`, 1 cm from each other, in squares of four.
struct Floor {
    static constexpr int side = 41;

    explicit Floor(const glm::dvec3& eye) {
        const auto add = [&](SurfaceSamples& to, int i, int j) {
            const glm::dvec3 at(-0.3 + 0.01 * i, -0.2 + 0.01 * j, 0.0);
            to.add({at, {0.0, 0.0, 1.0}, glm::normalize(eye - at)}, 0, 1.0, 0);
        };
        for (int j = 0; j < side; j += 4)
            for (int i = 0; i < side; i += 4)
                add(squares.corners, i, j);
        constexpr std::uint32_t across = side / 4;
        for (std::uint32_t row = 0; row < across; ++row)
            for (std::uint32_t column = 0; column < across; ++column) {
                const std::uint32_t corner = row * (across + 1) + column;
                squares.squares.push_back({corner, corner + 1, corner + across + 1, corner + across + 2});
            }
        for (int j = 0; j < side - 1; ++j)
            for (int i = 0; i < side - 1; ++i) {
                add(samples, i, j);
                squares.of_sample.push_back(
                    {static_cast<std::uint32_t>(j / 4) * across + static_cast<std::uint32_t>(i / 4),
                     0.25F * static_cast<float>(i % 4), 0.25F * static_cast<float>(j % 4)});
            }
    }

    SurfaceSamples samples;
    SampleSquares squares;
};

SurroundingsReflectances reflectances_of(const Stage& stage) {
    SurroundingsReflectances all;
    for (const Surface& surface : stage.surfaces)
        all.push_back(std::make_shared<const SurroundingsReflectance>(surface.material, true, false));
    return all;
}

// What the floor of `room` shows of it, under a rectangle.
struct LitRoom {
    Stage stage = make_stage("room").value();
    LightingOptions options = with_all_bounces();
    Interreflection indirect = light_up();
    SurroundingsReflectances surfaces = reflectances_of(stage);
    ReflectedView view{*indirect.geometry(), &indirect, nullptr, surfaces, options.instruction_set};
    Floor floor{stage.camera.position};

    static LightingOptions with_all_bounces() {
        LightingOptions options;
        options.bounces = all_bounces;
        return options;
    }

private:
    Interreflection light_up() const {
        const std::vector<Light> lights{light_of("rect:w=60cm,h=30cm", "3000lm", stage.light.position)};
        return Interreflection::of(stage, lights, options).value();
    }
};

// Beside a box, whose image has an edge.
TEST(ReflectedView, InterpolatesWhatChangesLittle) {
    LitRoom room;
    const Floor& floor = room.floor;
    for (const LobeRays& lobe : lobe_rays(core_material(room.stage.surfaces.front().material))) {
        const std::vector<glm::vec3> exact = room.view.luminance(floor.samples, {}, lobe);
        const std::vector<glm::vec3> found = room.view.luminance(floor.samples, floor.squares, lobe);
        double mean = 0.0;
        double worst = 0.0;
        double square = 0.0;
        for (std::size_t i = 0; i < exact.size(); ++i) {
            const double off = static_cast<double>(found[i].y) - static_cast<double>(exact[i].y);
            mean += static_cast<double>(exact[i].y) / static_cast<double>(exact.size());
            square += off * off / static_cast<double>(exact.size());
            worst = std::max(worst, std::abs(off));
        }
        ASSERT_GT(mean, 0.0);
        EXPECT_LT(std::sqrt(square), 2e-3 * mean);
        EXPECT_LT(worst, 3e-2 * mean);
        EXPECT_GT(worst, 0.0);                                      // some are interpolated
        EXPECT_NEAR(found.front().y, exact.front().y, 1e-5 * mean); // a corner
    }
}

// Sixteen points of a pixel on an outline have as many rays together as a whole pixel, and show in the mean what they
// show with all rays each.
TEST(ReflectedView, PointsOfAnOutlineShareRays) {
    LitRoom room;
    const Floor& floor = room.floor;
    for (const char* material : {"ue4:base=0.9,metallic=1,roughness=0.9", "ue4:base=0.9,metallic=1,roughness=0.5"})
        for (const LobeRays& lobe : lobe_rays(core_material(parse_material(material).value()))) {
            const std::vector<glm::vec3> exact = room.view.luminance(floor.samples, {}, lobe);
            SurfaceSamples outline = floor.samples;
            for (std::size_t i = 0; i < outline.size(); ++i) {
                outline.pixel[i] = static_cast<std::uint32_t>(i / 16);
                outline.center[i] = -1;
            }
            const std::vector<glm::vec3> found = room.view.luminance(outline, {}, lobe);
            ASSERT_EQ(found.size() % 16, 0U);
            double square = 0.0;
            double mean = 0.0;
            std::size_t same = 0;
            for (std::size_t i = 0; i < found.size(); i += 16) {
                double off = 0.0;
                for (std::size_t k = i; k < i + 16; ++k) {
                    off += (static_cast<double>(found[k].y) - static_cast<double>(exact[k].y)) / 16.0;
                    mean += static_cast<double>(exact[k].y) / static_cast<double>(found.size());
                    same += found[k].y == exact[k].y ? 1U : 0U;
                }
                square += off * off * 16.0 / static_cast<double>(found.size());
            }
            EXPECT_LT(same, found.size() / 100) << material;
            EXPECT_LT(std::sqrt(square), 0.01 * mean) << material;
        }
}

// A mirror shows a mirror, which shows a lit wall.
TEST(ReflectedView, GoesOnFromMetals) {
    const Material mirror = GgxMaterial{glm::dvec3(0.9), 0.001};
    const glm::dvec3 up(0.0, 0.0, 1.0);
    const glm::dvec3 along(0.0, 1.0, 0.0);
    Stage stage;
    stage.surfaces = {
        {"low", panel_facing({0.0, 0.0, 0.0}, up, along, 4.0, 4.0), mirror},
        {"high", panel_facing({0.0, 0.0, 1.0}, -up, along, 4.0, 4.0), mirror},
        {"wall", panel_facing({0.0, 2.0, 0.5}, {0.0, -1.0, 0.0}, up, 4.0, 1.0), LambertMaterial{glm::dvec3(0.5)}}};
    const std::vector<Light> lights{light_of("rect:w=60cm,h=30cm", "3000lm", {0.0, 0.0, 0.9})};
    LightingOptions options;
    options.bounces = all_bounces;
    const Interreflection indirect = Interreflection::of(stage, lights, options).value();
    const SurroundingsReflectances surfaces = reflectances_of(stage);
    ReflectedView view(*indirect.geometry(), &indirect, nullptr, surfaces, options.instruction_set);
    const std::vector<LobeRays> lobes = lobe_rays(core_material(mirror));
    ASSERT_EQ(lobes.size(), 1U);
    EXPECT_TRUE(lobes.front().is_metal());
    // What one mirror shows along a ray that leaves it for the next mirror, and what that shows of the wall.
    const glm::dvec3 rises = glm::normalize(glm::dvec3(0.0, 1.0, 1.0));
    const auto shown = [&](std::size_t surface, const glm::dvec3& at, const glm::dvec3& normal, const glm::dvec3& eye) {
        SurfaceSamples one;
        one.surface = surface;
        one.add({at, normal, eye}, 0, 1.0, 0);
        one.finish_chunk();
        return view.luminance(one, {}, lobes.front()).front().y;
    };
    const float of_wall = shown(1, {0.0, 1.5, 1.0}, -up, -rises);
    const float of_mirror = shown(0, {0.0, 0.5, 0.0}, up, glm::normalize(glm::dvec3(0.0, -1.0, 1.0)));
    ASSERT_GT(of_wall, 0.0F);
    const double albedo = lobes.front().albedo(std::sqrt(0.5)).y;
    EXPECT_GT(albedo, 0.9);
    EXPECT_NEAR(of_mirror / of_wall, albedo, 0.01 * albedo);
}

// The rays of an anisotropic lobe at any place, against the sum over directions.
TEST(LobeRays, FollowTheGrain) {
    const Material brushed = parse_material("ggx:f0=0.9,alpha=0.3,anisotropy=0.7,rotation=20").value();
    const CoreMaterial core = core_material(brushed);
    const auto& exact = std::get<shading::Anisotropic<double>>(core);
    const std::vector<LobeRays> lobes = lobe_rays(core, 16);
    ASSERT_EQ(lobes.size(), 1U);
    const glm::dvec3 normals[] = {{0.0, 0.0, 1.0}, {0.0, -1.0, 0.0}, {0.6, 0.0, 0.8}};
    for (const glm::dvec3& normal : normals)
        for (const double azimuth : {0.1, 1.3, 2.9, 4.4}) {
            const double cosine = 0.6;
            const Frame frame = frame_about(glm::dvec3(0.0), normal);
            const glm::dvec3 aside = std::cos(azimuth) * frame.x + std::sin(azimuth) * frame.y;
            const glm::dvec3 side = glm::cross(normal, aside);
            const glm::dvec3 view = cosine * normal + std::sqrt(1.0 - cosine * cosine) * aside;
            // What a sky shows that is brighter to one side.
            const auto sky = [&](double x, double y) { return 1.0 + x + 2.0 * y * y + 0.5 * y; };
            double by_rays = 0.0;
            const LobeRays::View of = lobes.front().view(cosine, normal, aside);
            for (std::size_t i = 0; i < lobes.front().count(); ++i) {
                const LobeRay ray = lobes.front().ray(of, i);
                const glm::dvec3 way = glm::normalize(glm::dvec3(ray.direction));
                by_rays += static_cast<double>(ray.weight.x) * sky(way.x, way.y);
            }
            double truth = 0.0;
            constexpr int steps = 300;
            for (int i = 0; i < steps; ++i)
                for (int k = 0; k < steps; ++k) {
                    const auto sample = shading::sample_brdf(exact, vec(normal), vec(view),
                                                             {(i + 0.5) / steps, (k + 0.5) / steps, 0.5});
                    const glm::dvec3 way = vec(sample.l);
                    const double n_dot_l = glm::dot(way, normal);
                    if (!(n_dot_l > 0.0) || !(sample.pdf > 0.0)) continue;
                    truth += shading::brdf(exact, vec(normal), sample.l, vec(view)).x * n_dot_l / sample.pdf *
                             sky(glm::dot(way, aside), glm::dot(way, side)) / (steps * steps);
                }
            EXPECT_NEAR(by_rays, truth, 0.02 * truth) << normal.z << ' ' << azimuth;
        }
}

} // namespace
} // namespace gonio::detail
