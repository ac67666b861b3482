// Lights narrower than a pixel: each pixel has the luminance of what it shows, wherever the pixels lie.
#include <gonio/preview/render.hpp>
#include <gonio/scene/emissive_lights.hpp>
#include <gonio/scene/emitter.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/scene/surface_emission.hpp>

#include "../light/lights.hpp"
#include "../scene/emitted.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace gonio {
namespace {

// Nothing but a black floor far below.
Stage darkness() {
    Stage stage;
    stage.surfaces.push_back({"floor", Plane{{0.0, 0.0, -50.0}}, LambertMaterial{glm::dvec3(0.0)}});
    stage.camera = {{0.1, -8.0, 1.3}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, 30.0};
    return stage;
}

RenderOptions small() {
    RenderOptions options;
    options.width = 48;
    options.height = 40;
    return options;
}

Rendering picture(const Stage& stage, const std::vector<Light>& lights, const RenderOptions& options = small()) {
    return render(stage, lights, stage.camera, options).value();
}

double sum_of(const Rendering& rendering) {
    double sum = 0.0;
    for (std::size_t i = 0; i < rendering.luminance_nt.pixels.size(); i += 3)
        sum += static_cast<double>(rendering.luminance_nt.pixels[i]);
    return sum;
}

// The share of a pixel's rays that meet the light.
double share_met(const Light& light, const CameraRays& rays, int x, int y, int across) {
    int met = 0;
    for (int j = 0; j < across; ++j)
        for (int i = 0; i < across; ++i)
            met += distance_to(light, rays.ray(x + (i + 0.5) / across, y + (j + 0.5) / across)).has_value() ? 1 : 0;
    return static_cast<double>(met) / (across * across);
}

constexpr std::array thin_shapes{
    "sphere:r=8mm",      "disk:r=1cm,two-sided", "ellipse:w=1.6m,h=8mm,two-sided", "rect:w=1.3m,h=4mm,two-sided",
    "tube:r=3mm,l=1.5m", "cylinder:r=4mm,l=1.1m"};

TEST(ThinLights, CoverOfPixelsWhatRaysMeet) {
    const Stage stage = darkness();
    const RenderOptions options = small();
    const CameraRays rays(stage.camera, options.width, options.height);
    for (const char* shape : thin_shapes) {
        const Light light = light_of(shape, "1000nt", {0.13, 0.2, 1.1}, {0.3, -1.0, 0.2}, {0.4, 0.1, 1.0});
        const Rendering shown = picture(stage, {light});
        int covered = 0;
        for (int y = 0; y < options.height; ++y)
            for (int x = 0; x < options.width; ++x) {
                const double share = static_cast<double>(shown.luminance_nt.at(x, y)[0]) / 1000.0;
                if (share_met(light, rays, x, y, 16) == 0.0 && share == 0.0) continue;
                ++covered;
                // Within what 400×400 rays count.
                EXPECT_NEAR(share, share_met(light, rays, x, y, 400), 0.003) << shape << " at " << x << ", " << y;
                EXPECT_EQ(shown.shows_light[static_cast<std::size_t>(y * options.width + x)], share > 0.0 ? 1 : 0);
            }
        EXPECT_GE(covered, 1) << shape;
    }
}

// No flicker: as a light moves over the pixels, as much of it is seen as its cone of directions says.
TEST(ThinLights, MoveWithoutFlicker) {
    const Stage stage = darkness();
    const RenderOptions options = small();
    const double pixel = 2.0 * std::tan(0.5 * 30.0 * std::numbers::pi / 180.0) / options.height;
    for (int i = 0; i < 40; ++i) {
        // In the plane through the target at right angles to the view, where a length is 8.0056 times its place.
        const glm::dvec3 ahead = glm::normalize(stage.camera.target - stage.camera.position);
        const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(0.0, 0.0, 1.0)));
        const double depth = glm::length(stage.camera.target - stage.camera.position);
        const Light light = light_of("disk:r=2mm", "1000nt", stage.camera.target + 0.0061 * i * right, -ahead);
        const double radius = 0.002 / depth / pixel;
        const double expected = 1000.0 * std::numbers::pi * radius * radius;
        EXPECT_NEAR(sum_of(picture(stage, {light})), expected, 2e-6 * expected + 1e-6);
    }
}

// A panel before one half hides that half, and what is in front of the other half of a second light does not matter.
TEST(ThinLights, AreHiddenByWhatIsBeforeThem) {
    Stage stage = darkness();
    const Light tube = light_of("tube:r=3mm,l=1.5m", "1000nt", {0.0, 0.0, 1.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, 1.0});
    const double all = sum_of(picture(stage, {tube}));
    // Seen from the eye at x = 0.1, its edge at x = 0.0 and y = −1 covers the tube from a seventh of 0.1 m on.
    stage.surfaces.push_back({"panel", panel_facing({0.5, -1.0, 1.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, 1.0}, 1.0, 2.0),
                              LambertMaterial{glm::dvec3(0.0)}});
    const double half = sum_of(picture(stage, {tube}));
    const double left = (0.75 - 0.1 / 7.0) / 1.5; // of the length
    EXPECT_NEAR(half / all, left, 0.01);
    const Light behind = light_of("tube:r=3mm,l=1.5m", "1000nt", {0.0, 0.5, 1.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, 1.0});
    EXPECT_LT(sum_of(picture(stage, {tube, behind})), 2.0 * half);
}

// A light before another of the same outline is seen alone.
TEST(ThinLights, HideEachOther) {
    const Stage stage = darkness();
    const glm::dvec3 eye = stage.camera.position;
    const glm::dvec3 near(0.0, 0.0, 1.0);
    const glm::dvec3 far = eye + 2.0 * (near - eye);
    const Light front = light_of("sphere:r=4mm", "1000nt", near);
    const Light back = light_of("sphere:r=8mm", "300nt", far);
    const double alone = sum_of(picture(stage, {front}));
    EXPECT_NEAR(sum_of(picture(stage, {back, front})), alone, 1e-5 * alone);
    EXPECT_NEAR(sum_of(picture(stage, {front, back})), alone, 1e-5 * alone);
}

// A thin surface of the stage that emits shows what a light of its shape shows.
TEST(ThinLights, SurfacesThatEmitAreThin) {
    const Light tube = light_of("tube:r=4mm,l=1.5m", "500nt", {0.0, 0.0, 1.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, 1.0});
    Stage stage = darkness();
    Surface lamp{"lamp", Capsule{{0.0, 0.0, 1.0}, {1, 0, 0}, 0.75, 0.004}, LambertMaterial{glm::dvec3(0.0)}};
    lamp.emits = parse_surface_emission("500nt").value();
    stage.surfaces.push_back(lamp);
    const Rendering shown = picture(stage, test::emitted_by(stage));
    const Rendering expected = picture(darkness(), {tube});
    ASSERT_GT(sum_of(expected), 0.0);
    for (std::size_t i = 0; i < expected.luminance_nt.pixels.size(); ++i)
        EXPECT_NEAR(shown.luminance_nt.pixels[i], expected.luminance_nt.pixels[i], 1e-3F);
}

// What a thin light leaves of its pixels shows the surface behind it as if the light were not shown.
TEST(ThinLights, LeaveTheRestOfThePixel) {
    Stage stage = darkness();
    stage.surfaces.push_back({"wall", panel_facing({0.0, 1.0, 1.0}, {0.0, -1.0, 0.0}, {0.0, 0.0, 1.0}, 9.0, 9.0),
                              LambertMaterial{glm::dvec3(0.5)}});
    const Light lamp = light_of("point", "5000cd", {0.0, -7.0, 1.0});
    const Light dim = light_of("rect:w=1.3m,h=8mm,two-sided", "0.001nt", {0.0, 0.0, 1.0}, {0.3, -1.0, 0.2});
    RenderOptions hidden = small();
    hidden.shows_lights = false;
    const Rendering without = picture(stage, {lamp, dim}, hidden);
    const Rendering with = picture(stage, {lamp, dim});
    const CameraRays rays(stage.camera, hidden.width, hidden.height);
    int covered = 0;
    for (int y = 0; y < hidden.height; ++y)
        for (int x = 0; x < hidden.width; ++x) {
            const bool is_met = share_met(dim, rays, x, y, 8) > 0.0;
            const double share = is_met ? share_met(dim, rays, x, y, 200) : 0.0;
            covered += share > 0.01 ? 1 : 0;
            const auto wall = static_cast<double>(without.luminance_nt.at(x, y)[0]);
            EXPECT_NEAR(static_cast<double>(with.luminance_nt.at(x, y)[0]), (1.0 - share) * wall, 0.015 * wall);
        }
    EXPECT_GT(covered, 5);
}

} // namespace
} // namespace gonio
