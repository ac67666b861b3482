#include <gonio/light/light_color.hpp>
#include <gonio/scene/camera.hpp>
#include <gonio/scene/occlusion.hpp>
#include <gonio/transport/exchange_geometry.hpp>
#include <gonio/transport/ray_bundle.hpp>
#include <gonio/transport/sky_light.hpp>

#include "../scaled.hpp"
#include "stages.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace gonio {
namespace {

using detail::ExchangeGeometry;
using detail::SkyLight;
using test::Vec;

Sky sky_of(const char* text) {
    return resolve_sky(parse_sky_description(text).value()).value();
}

LightingOptions under(const char* text) {
    LightingOptions options;
    options.sky = sky_of(text);
    return options;
}

std::shared_ptr<const ExchangeGeometry> geometry_of(const Stage& stage) {
    ExchangeQuality quality;
    quality.node_rays = quality.sky_rays;
    return std::make_shared<const ExchangeGeometry>(stage, std::span<const Light>(), quality, 0,
                                                    LightingOptions().instruction_set);
}

SkyLight on(const Stage& stage, const LightingOptions& options) {
    return {options, geometry_of(stage)};
}

// What is open to the sky, direction by direction: shares nothing with SkyLight but the sky itself.
std::vector<Vec> open_directions(const Stage& stage, const Hit& hit, std::size_t count) {
    const Frame frame = detail::frame_about(hit.position, hit.normal);
    std::vector<Vec> open;
    for (const Vec& local : detail::cosine_directions(count)) {
        const Vec direction = frame.to_world(local);
        if (!is_hidden(stage, hit.surface, hit.position, direction, std::numeric_limits<double>::infinity()))
            open.push_back(direction);
    }
    return open;
}

// `count` is that of open_directions().
Vec counted(const Sky& sky, std::span<const Vec> open, std::size_t count) {
    Vec sum(0.0);
    for (const Vec& direction : open)
        sum += sky.radiance(direction);
    return std::numbers::pi * sum / static_cast<double>(count);
}

std::vector<Hit> seen(const Stage& stage, int side) {
    std::vector<Hit> points;
    const CameraRays rays(stage.camera, side, side);
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            if (const std::optional<Hit> hit = first_hit(stage, rays.ray(i + 0.5, j + 0.5))) points.push_back(*hit);
    return points;
}

constexpr const char* low_sun = "cie:12,sun=200/15,horizontal=10klx";
constexpr const char* high_sun = "cie:12,sun=130/50,horizontal=10klx";
constexpr const char* overcast = "cie:1,horizontal=10klx";
constexpr const char* even = "uniform:horizontal=10klx";

TEST(SkyLight, IsExactWhereNothingHidesIt) {
    Stage open;
    open.surfaces = {{"floor", Plane{Vec(0.0), Vec(0.0, 0.0, 1.0)}, LambertMaterial{Vec(0.5)}}};
    for (const char* text : {low_sun, high_sun, overcast, even}) {
        const LightingOptions options = under(text);
        EXPECT_NEAR(on(open, options).on_surface(0, 0, {1.0, 2.0, 0.0}).y, 10e3, 1e-3) << text;
        const SkyLight light = on(open, options);
        EXPECT_NEAR(detail::sky_light_at(light.sky(), options, *light.geometry(), {1.0, 2.0, 0.8}, {0.0, 0.0, 1.0},
                                         Vec(10e3), 512)
                        .y,
                    10e3, 1e-3)
            << text;
    }
}

// Root mean square, of the mean where the camera looks: 0.08 to 0.5 %, and between the spheres, where nodes are far
// apart for their sizes, 0.4 to 0.8 %. The count itself has an error of 0.05 %.
TEST(SkyLight, AgreesWithCountedDirections) {
    constexpr std::size_t count = 20000;
    for (const std::string_view name : {"floor", "card", "street", "spheres"}) {
        if (test::is_sanitized && name != "floor") continue;
        const Stage stage = make_stage(name).value();
        const std::shared_ptr<const ExchangeGeometry> geometry = geometry_of(stage);
        const std::vector<Hit> points = seen(stage, 8);
        std::vector<std::vector<Vec>> open;
        for (const Hit& hit : points)
            open.push_back(open_directions(stage, hit, count));
        for (const char* text : {low_sun, high_sun, overcast, even}) {
            const LightingOptions options = under(text);
            const SkyLight light(options, geometry);
            double mean = 0.0;
            double square = 0.0;
            for (std::size_t i = 0; i < points.size(); ++i) {
                const double expected = counted(options.sky, open[i], count).y;
                const double found = light.on_surface(points[i].surface, points[i].face, points[i].position).y;
                mean += expected;
                square += (found - expected) * (found - expected);
            }
            const auto all = static_cast<double>(points.size());
            EXPECT_LE(std::sqrt(square / all), 0.01 * mean / all) << name << ' ' << text;
        }
    }
}

TEST(SkyLight, ReceiversAgreeWithCountedDirections) {
    const Stage stage = make_stage("floor").value();
    for (const char* text : {low_sun, high_sun, overcast, even}) {
        const LightingOptions options = under(text);
        const SkyLight light = on(stage, options);
        for (const Vec normal : {Vec(0.0, 0.0, 1.0), Vec(0.6, 0.0, 0.8), Vec(0.0, -1.0, 0.0)}) {
            Hit hit;
            hit.surface = stage.surfaces.size();
            hit.position = {0.1, 0.2, 0.4};
            hit.normal = normal;
            constexpr std::size_t count = 100000;
            const double expected = counted(options.sky, open_directions(stage, hit, count), count).y;
            EXPECT_NEAR(detail::sky_light_at(light.sky(), options, *light.geometry(), hit.position, normal,
                                             options.sky.irradiance(normal), 8192)
                            .y,
                        expected, 2e-3 * 10e3)
                << text;
        }
    }
}

TEST(SkyLight, TurnsWithTheStage) {
    const auto turned = [](const Vec& v) { return Vec(-v.y, v.x, v.z); }; // azimuths from north fall by 90°
    Stage stage;
    stage.surfaces = {{"floor", Plane{Vec(0.0), Vec(0.0, 0.0, 1.0)}, LambertMaterial{Vec(0.5)}},
                      {"ball", Ball{{0.5, 0.2, 0.6}, 0.5}, LambertMaterial{Vec(0.5)}}};
    Stage other = stage;
    other.surfaces[1].geometry = Ball{turned({0.5, 0.2, 0.6}), 0.5};
    const LightingOptions here = under("cie:12,sun=200/30,horizontal=10klx");
    const LightingOptions there = under("cie:12,sun=110/30,horizontal=10klx");
    const SkyLight a = on(stage, here);
    const SkyLight b = on(other, there);
    for (const Vec at : {Vec(0.0, 0.0, 0.0), Vec(0.6, 0.3, 0.0), Vec(1.4, -0.3, 0.0)})
        EXPECT_NEAR(a.on_surface(0, 0, at).y, b.on_surface(0, 0, turned(at)).y,
                    0.006 * 10e3); // twice the error of a node
}

TEST(SkyLight, IsLinear) {
    const Stage stage = make_stage("floor").value();
    const LightingOptions once = under(low_sun);
    const LightingOptions twice = under("cie:12,sun=200/15,horizontal=20klx");
    const std::shared_ptr<const ExchangeGeometry> geometry = geometry_of(stage);
    const SkyLight a(once, geometry);
    const SkyLight b(twice, geometry);
    for (const Hit& hit : seen(stage, 8)) {
        const double lx = a.on_surface(hit.surface, hit.face, hit.position).y;
        EXPECT_NEAR(b.on_surface(hit.surface, hit.face, hit.position).y, 2.0 * lx, 1e-9 * 10e3);
    }
}

// Without shadows everything sees all of its hemisphere; on a sphere, by 1024 directions and between nodes.
TEST(SkyLight, WithoutShadowsIsThatOfAnOpenPlane) {
    const Stage stage = make_stage("floor").value();
    LightingOptions options = under(high_sun);
    options.shadows = Shadows::off;
    const SkyLight light = on(stage, options);
    for (const Hit& hit : seen(stage, 6)) {
        const bool is_flat = is_sheet(stage.surfaces[hit.surface].geometry);
        EXPECT_NEAR(light.on_surface(hit.surface, hit.face, hit.position).y, options.sky.irradiance(hit.normal).y,
                    (is_flat ? 1e-6 : 0.01) * 10e3);
    }
}

} // namespace
} // namespace gonio
