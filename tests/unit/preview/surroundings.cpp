// Captures of a lit stage, and the methods of engines for sky and reflections.
#include <gonio/light/light_color.hpp>
#include <gonio/measure/stage_lamp.hpp>
#include <gonio/preview/capture.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/sky/sky_description.hpp>
#include <gonio/transport/receiver_light.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <vector>

namespace gonio {
namespace {

using Vec = glm::dvec3;

Sky sky_of(const char* text) {
    return resolve_sky(parse_sky_description(text).value()).value();
}

double lx_of(const Vec& rgb) {
    return glm::dot(rgb, rec709_luminance);
}

// The captured picture gives a plane the illuminance that a receiver has at the same place.
TEST(Capture, GivesTheIlluminanceOfAProbe) {
    const Stage stage = make_stage("room").value();
    const std::vector<Light> lights{measure::lamp_over(stage)};
    const Vec place(0.4, 0.3, 1.1);
    RenderOptions options;
    options.bounces = all_bounces;
    const EnvironmentMap map = capture(stage, lights, place, 128, options).value();
    options.shows_lights = false;
    const EnvironmentMap without = capture(stage, lights, place, 128, options).value();
    const ReceiverLight receiver_light = ReceiverLight::on(stage, lights, options).value();
    for (const Vec& normal : {Vec(0.0, 0.0, 1.0), Vec(1.0, 0.0, 0.0), Vec(0.0, -1.0, 0.0), Vec(0.0, 0.0, -1.0)}) {
        const Receiver receiver{place, normal};
        const ReceiverLight::Shares shares = receiver_light.at({&receiver, 1});
        const double direct = probe(lights, {&receiver, 1}).value().illuminance_lx[0] * shares.visible[0];
        // The room's own surfaces are glossy, so what it shows from one side is not what a matte one would send; the
        // lamp is a few dozen texels.
        const double indirect = shares.indirect_lx[0];
        EXPECT_NEAR(lx_of(map.irradiance(normal) - without.irradiance(normal)), direct, 0.02 * direct + 0.01);
        EXPECT_NEAR(lx_of(without.irradiance(normal)), indirect, 0.25 * (indirect + direct) + 0.5) << normal.x;
    }
}

// In a room of Lambertian surfaces it is the whole of what bounces.
TEST(Capture, HasAllThatBounces) {
    Stage stage = make_stage("room").value();
    for (Surface& surface : stage.surfaces)
        surface.material = LambertMaterial{Vec(0.5)};
    const std::vector<Light> lights{measure::lamp_over(stage)};
    const Vec place(0.4, 0.3, 1.1);
    RenderOptions options;
    options.bounces = all_bounces;
    const ReceiverLight receiver_light = ReceiverLight::on(stage, lights, options).value();
    options.shows_lights = false;
    const EnvironmentMap map = capture(stage, lights, place, 128, options).value();
    for (const Vec& normal : {Vec(0.0, 0.0, 1.0), Vec(1.0, 0.0, 0.0), Vec(0.0, -1.0, 0.0), Vec(0.0, 0.0, -1.0)}) {
        const Receiver receiver{place, normal};
        const double expected = receiver_light.at({&receiver, 1}).indirect_lx[0];
        EXPECT_NEAR(lx_of(map.irradiance(normal)), expected, 0.01 * expected) << normal.x << ' ' << normal.z;
    }
}

// An open sky alone: the same picture as the sky itself.
TEST(Capture, ShowsTheSky) {
    const Stage empty;
    RenderOptions options;
    options.sky = sky_of("cie:12,sun=120/40,horizontal=20klx");
    const EnvironmentMap map = capture(empty, {}, Vec(0.0), 64, options).value();
    for (int row = 0; row < map.grid().height(); row += 3)
        for (int column = 0; column < map.grid().width(); column += 5) {
            const Vec direction = map.grid().direction({column + 0.5, row + 0.5});
            const double expected = lx_of(options.sky.radiance(direction));
            EXPECT_NEAR(lx_of(map.texel({column, row})), expected, 1e-5 * expected + 1e-6);
        }
}

TEST(Capture, RefusesPlacesInsideSolids) {
    Stage stage;
    stage.surfaces = {{"floor", Plane{Vec(0.0), Vec(0.0, 0.0, 1.0)}, LambertMaterial{}},
                      {"ball", Ball{Vec(0.0, 0.0, 1.0), 0.5}, LambertMaterial{}}};
    for (const Vec& place : {Vec(0.0, 0.0, -1.0), Vec(0.0, 0.2, 1.1)}) {
        const Result<EnvironmentMap> found = capture(stage, {}, place, 16, {});
        ASSERT_FALSE(found);
        EXPECT_NE(found.error().diagnostics.back().message.find("inside or behind"), std::string::npos);
    }
}

Stage open_floor(const char* material) {
    Stage stage;
    stage.name = "open";
    stage.surfaces = {{"floor", Plane{Vec(0.0), Vec(0.0, 0.0, 1.0)}, parse_material(material).value()}};
    stage.camera.position = {0.0, -2.0, 1.0};
    stage.camera.target = {0.0, 0.0, 0.0};
    return stage;
}

double middle_nt(const Stage& stage, const RenderOptions& options) {
    const Image picture = render(stage, {}, stage.camera, options).value().luminance_nt;
    const float* const pixel = picture.at(picture.width / 2, picture.height / 2);
    return glm::dot(rec709_luminance, Vec(pixel[0], pixel[1], pixel[2]));
}

constexpr SurroundingsMethod of_sky[] = {SurroundingsMethod::spherical_harmonics, SurroundingsMethod::split_sum,
                                         SurroundingsMethod::dominant_direction, SurroundingsMethod::prefiltered};

// Nothing is in the way and the sky is even: every method is right, up to the lookup of its table; Unreal's has
// another shadowing of facets.
TEST(SurroundingsMethods, AgreeUnderAnEvenSky) {
    RenderOptions options;
    options.width = options.height = 9;
    options.sky = sky_of("10klx");
    for (const char* material : {"frostbite:base=0.5,smoothness=0.4", "ue4:base=0.9,metallic=1,roughness=0.5"}) {
        const Stage stage = open_floor(material);
        options.surroundings = SurroundingsMethod::exact;
        const double exact = middle_nt(stage, options);
        const bool is_metal = std::string_view(material).starts_with("ue4");
        for (const SurroundingsMethod method : of_sky) {
            // Half of them with each.
            if (is_metal ==
                (method == SurroundingsMethod::prefiltered || method == SurroundingsMethod::dominant_direction))
                continue;
            options.surroundings = method;
            const double tolerance = method == SurroundingsMethod::split_sum ? 0.15 : 0.01;
            EXPECT_NEAR(middle_nt(stage, options), exact, tolerance * exact) << material << ' ' << to_text(method);
        }
    }
}

// Under a clear sky they differ, and the harmonics only where light is diffuse.
TEST(SurroundingsMethods, DifferUnderAClearSky) {
    RenderOptions options;
    options.width = options.height = 9;
    options.sky = sky_of("cie:12,sun=0/15,horizontal=10klx");
    const Stage metal = open_floor("ue4:base=0.9,metallic=1,roughness=0.6");
    const double exact = middle_nt(metal, options);
    for (const SurroundingsMethod method :
         {SurroundingsMethod::split_sum, SurroundingsMethod::dominant_direction, SurroundingsMethod::prefiltered}) {
        options.surroundings = method;
        const double nt = middle_nt(metal, options);
        EXPECT_GT(std::abs(nt / exact - 1.0), 0.01) << to_text(method);
        EXPECT_LT(std::abs(nt / exact - 1.0), 0.8) << to_text(method);
    }
    options.surroundings = SurroundingsMethod::spherical_harmonics;
    EXPECT_NEAR(middle_nt(metal, options), exact, 1e-6 * exact);
}

// A mirror in a room sees the walls of the box: closely where the box is the room.
TEST(SurroundingsMethods, ParallaxBoxShowsTheRoom) {
    const Stage stage = [] {
        Stage room = make_stage("room").value();
        for (Surface& surface : room.surfaces)
            surface.material = surface.subject ? parse_material("ue4:base=0.9,metallic=1,roughness=0.3").value()
                                               : Material(LambertMaterial{Vec(0.5)});
        return room;
    }();
    const std::vector<Light> lights{measure::lamp_over(stage)};
    RenderOptions options;
    options.width = options.height = 64;
    options.bounces = all_bounces;
    const Rendering exact = render(stage, lights, stage.camera, options).value();
    options.known = exact.indirect;
    options.probe = std::make_shared<const LocalProbe>(
        local_probe(stage, lights, 0.5 * (stage.camera.position + stage.camera.target), options).value());
    for (const SurroundingsMethod method : {SurroundingsMethod::parallax_box, SurroundingsMethod::parallax_sphere}) {
        options.surroundings = method;
        const Rendering found = render(stage, lights, stage.camera, options).value();
        double sum = 0.0;
        double off = 0.0;
        double others = 0.0;
        for (std::size_t pixel = 0; pixel < exact.shows_subject.size(); ++pixel) {
            const double truth = exact.luminance_nt.pixels[3 * pixel + 1];
            const double difference = found.luminance_nt.pixels[3 * pixel + 1] - truth;
            if (exact.shows_subject[pixel] == 0) {
                others += std::abs(difference); // edges of subjects alone
                continue;
            }
            sum += truth;
            off += std::abs(difference);
        }
        EXPECT_LT(others, 0.2 * off) << to_text(method);
        EXPECT_GT(off, 0.005 * sum) << to_text(method);
        EXPECT_LT(off, 0.35 * sum) << to_text(method);
    }
}

} // namespace
} // namespace gonio
