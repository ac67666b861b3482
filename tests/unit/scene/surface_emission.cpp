#include <gonio/base/gauss_legendre.hpp>
#include <gonio/scene/emissive_lights.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/surface_emission.hpp>

#include "emitted.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace gonio {
namespace {

using std::numbers::pi;
using test::emitted_by;
using Vec = glm::dvec3;

const Ball ball{{0.3, -0.2, 1.1}, 0.15};
const Capsule capsule = capsule_between({0.1, 0.2, 0.9}, {0.5, -0.3, 1.4}, 0.07);
const Panel panel = panel_facing({-0.2, 0.4, 1.2}, glm::normalize(Vec(0.3, -0.5, 0.8)), {0, 0, 1}, 0.6, 0.25);
const Box box{aimed_frame({0.1, 0.1, 1.0}, {0.2, 0.3, -1.0}, {0, 1, 0}), {0.2, 0.1, 0.3}};
const std::array<Primitive, 4> emitters{ball, capsule, panel, box};

SurfaceEmission emission(const char* text) {
    return parse_surface_emission(text).value();
}

Stage stage_with(const Primitive& geometry, const char* emits) {
    Stage stage;
    stage.surfaces = {{"floor", Plane{}, {}}, {"lamp", geometry, {}}};
    stage.surfaces[1].emits = emission(emits);
    return stage;
}

std::string refusal(const char* text) {
    const Result<SurfaceEmission> read = parse_surface_emission(text);
    return read ? "no failure" : to_text(read.error().diagnostics.back());
}

std::string refusal(const Primitive& geometry, const char* amount) {
    const Result<Nits> luminance = emitted_luminance(geometry, parse_photometric_value(amount).value());
    return luminance ? "no failure" : to_text(luminance.error().diagnostics.back());
}

TEST(SurfaceEmission, ReadsAnAmountAndAColor) {
    EXPECT_EQ(emission("500nt").amount.number, 500.0);
    EXPECT_EQ(emission("500nt").color, Vec(1.0));
    EXPECT_EQ(emission("60W@90lm/W").amount.unit.efficacy_lm_per_w, 90.0);
    const SurfaceEmission red = emission("800lm,color=rgb(1,0,0)");
    EXPECT_EQ(red.amount.unit.unit->symbol, "lm");
    EXPECT_NEAR(red.color.x * 0.21263900587151027, 1.0, 1e-12); // of luminance 1
    EXPECT_EQ(red.color.y, 0.0);
}

TEST(SurfaceEmission, RefusesWhatIsNoAmount) {
    EXPECT_EQ(refusal(""), "error[USE0104]: '' has no amount of light\nhint: for example 500nt, 800lm or "
                           "500nt,color=3000K");
    EXPECT_EQ(refusal("color=3000K"), "error[USE0104]: 'color=3000K' has no amount of light\nhint: for example 500nt, "
                                      "800lm or 500nt,color=3000K");
    EXPECT_EQ(refusal("500nt,color"),
              "error[USE0104]: 'color' has no value\nhint: for example 500nt, 800lm or 500nt,color=3000K");
    EXPECT_EQ(refusal("500nt,colr=3000K"),
              "error[USE0103]: unknown key 'colr' of 'emits'\nhint: did you mean 'color'? there are: color");
    EXPECT_EQ(refusal("500nt,color=d65,color=d65"),
              "error[USE0107]: 'emits:500nt,color=d65,color=d65' gives 'color' twice");
    for (const char* text : {"nan", "nannt", "infnt", "-5nt", "5", "5kg", "5m", "500nt,color=lila"})
        EXPECT_FALSE(parse_surface_emission(text)) << text;
}

TEST(SurfaceEmission, RefusesAmountsThatASurfaceDoesNotHave) {
    const std::string plane = "error[USE0107]: a plane cannot emit light: it has no end, so neither a flux nor a light "
                              "of its shape\nhint: use a panel, which has a width and a height";
    EXPECT_EQ(refusal(Plane{}, "800lm"), plane);
    EXPECT_EQ(refusal(Plane{}, "500nt"), plane);
    EXPECT_EQ(refusal(box, "100cd"), "error[USE0105]: a box has no luminous intensity in cd: it emits from six faces, "
                                     "in no direction more than in others\nhint: give its luminance or its flux, for "
                                     "example 500nt or 800lm");
    EXPECT_EQ(refusal(ball, "0nt"), "error[USE0106]: a surface that emits needs an amount greater than 0\nhint: a "
                                    "surface that only reflects needs none");
    for (const Primitive& geometry : emitters)
        for (const char* amount : {"0lm", "5lx", "1e40lm"})
            EXPECT_NE(refusal(geometry, amount), "no failure") << amount;
}

TEST(SurfaceEmission, LitAreasAreThoseOfTheirLights) {
    for (const Primitive& geometry : emitters) {
        const Nits luminance = emitted_luminance(geometry, parse_photometric_value("800lm").value()).value();
        EXPECT_NEAR(luminance.value * pi * lit_area(geometry) / 800.0, 1.0, 1e-14);
        const PhotometricUnit lm = parse_photometric_unit("lm").value();
        EXPECT_NEAR(express_emission(geometry, luminance, lm).value(), 800.0, 1e-12);
    }
    EXPECT_TRUE(std::isinf(lit_area(Plane{})));
}

// The lumens that cross a sphere around the surface, by quadrature of the lux of its lights: independent of any area.
TEST(SurfaceEmission, AroundASurfaceAllOfItsLumensArrive) {
    constexpr auto rule = gauss_legendre<20>();
    constexpr double radius = 3.0;
    constexpr int turns = 48;
    for (const Primitive& geometry : emitters) {
        const std::vector<Light> lights = emitted_by(stage_with(geometry, "800lm"));
        std::vector<Receiver> receivers;
        std::vector<double> areas;
        for (const QuadratureNode& node : rule)
            for (int turn = 0; turn < turns; ++turn) {
                const double azimuth = 2.0 * pi * turn / turns;
                const double across = std::sqrt(1.0 - node.at * node.at);
                const Vec out(across * std::cos(azimuth), across * std::sin(azimuth), node.at);
                receivers.push_back({Vec(0.1, 0.1, 1.0) + radius * out, -out});
                areas.push_back(radius * radius * node.weight * 2.0 * pi / turns);
            }
        const ProbeResult result = probe(lights, receivers).value();
        double flux_lm = 0.0;
        for (std::size_t i = 0; i < areas.size(); ++i)
            flux_lm += areas[i] * result.illuminance_lx[i];
        // The lux of a one-sided panel has a kink at its plane, and that of a box at each face's.
        const bool has_kinks = std::holds_alternative<Panel>(geometry) || std::holds_alternative<Box>(geometry);
        EXPECT_NEAR(flux_lm / 800.0, 1.0, has_kinks ? 5e-4 : 1e-5);
    }
}

// The same as an area light that is put there by hand.
TEST(EmissiveLights, AreAreaLightsOfTheSameShape) {
    struct Case {
        Primitive geometry;
        const char* shape;
        Vec position, direction, up;
    };
    const Vec axis = capsule.axis;
    const Vec aside = glm::normalize(glm::cross(axis, Vec(0.4, 0.1, 0.2)));
    const std::array cases{
        Case{ball, "sphere:r=15cm", ball.center, {0, 1, 0}, {1, 0, 0}},
        Case{Capsule{{0.1, 0.2, 0.9}, axis, 0.3, 0.07},
             "tube:r=7cm,l=60cm",
             {0.1, 0.2, 0.9},
             aside,
             glm::cross(axis, aside)},
        Case{panel, "rect:w=60cm,h=25cm", panel.frame.origin, panel.frame.z, panel.frame.y},
    };
    std::vector<Receiver> receivers;
    for (int i = 0; i < 40; ++i)
        receivers.push_back(
            {{std::sin(3.0 * i), std::cos(5.0 * i), 0.05 * i - 0.4}, {std::cos(i), std::sin(2.0 * i), 1.0}});
    for (const Case& one : cases)
        for (const char* amount : {"500nt", "800lm", "90cd", "200lx@2m", "11ev", "40W@90lm/W"}) {
            LightDescription description;
            description.shape = parse_shape(one.shape).value();
            description.intensity = parse_photometric_value(amount).value();
            description.position = one.position;
            description.direction = one.direction;
            description.up = one.up;
            Diagnostics diagnostics;
            const Light light = resolve_light(description, diagnostics).value();
            const std::vector<Light> emitted = emitted_by(stage_with(one.geometry, amount));
            ASSERT_EQ(emitted.size(), 1U);
            EXPECT_EQ(emitted[0].name, "lamp");
            EXPECT_TRUE(emitted[0].is_emitted_by(1));
            EXPECT_NEAR(glm::length(light.frame.origin - emitted[0].frame.origin), 0.0, 1e-15);
            const std::vector<double> expected = probe({&light, 1}, receivers).value().illuminance_lx;
            const std::vector<double> found = probe(emitted, receivers).value().illuminance_lx;
            // Where only a sliver of the light is above the horizon, the rounding of its frame counts.
            const double sliver = 1e-14 * *std::max_element(expected.begin(), expected.end());
            for (std::size_t i = 0; i < receivers.size(); ++i)
                EXPECT_NEAR(found[i], expected[i], 1e-12 * expected[i] + sliver) << one.shape << amount << i;
        }
}

TEST(EmissiveLights, ABoxIsSixRectangles) {
    const std::vector<Light> lights = emitted_by(stage_with(box, "500nt"));
    ASSERT_EQ(lights.size(), 6U);
    constexpr std::array names{"lamp-right", "lamp-left", "lamp-back", "lamp-front", "lamp-top", "lamp-bottom"};
    for (int i = 0; i < 6; ++i) {
        const Light& light = lights[static_cast<std::size_t>(i)];
        const Panel side = face(box, i);
        EXPECT_EQ(light.name, names.at(static_cast<std::size_t>(i)));
        EXPECT_EQ(light.emitted_by->face, i);
        EXPECT_NEAR(glm::dot(-light.frame.z, side.frame.z), 1.0, 1e-15); // emits outwards
        EXPECT_NEAR(std::abs(glm::dot(light.frame.x, side.frame.x)), 1.0, 1e-15);
        EXPECT_DOUBLE_EQ(light.luminance.value, 500.0);
        EXPECT_EQ(std::get<RectShape>(light.shape).width.value, side.width);
        EXPECT_EQ(std::get<RectShape>(light.shape).height.value, side.height);
    }
}

TEST(EmissiveLights, SurfacesOfOneNameEmitEachForItself) {
    Stage stage;
    stage.surfaces = {{"floor", Plane{}, {}}, {"lamp", ball, {}}, {"lamp", capsule, {}}, {"shade", panel, {}}};
    ASSERT_TRUE(let_emit(stage, {"lamp", emission("100lm,color=rgb(0,1,0)")}));
    const std::vector<Light> lights = emitted_by(stage);
    ASSERT_EQ(lights.size(), 2U);
    EXPECT_EQ(lights[0].name, "lamp-1");
    EXPECT_EQ(lights[1].name, "lamp-2");
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_TRUE(lights[i].is_emitted_by(i + 1));
        EXPECT_NEAR(lights[i].luminance.value * pi * lit_area(stage.surfaces[i + 1].geometry), 100.0, 1e-12);
        EXPECT_EQ(lights[i].color.x, 0.0);
    }
    const Result<void> unknown = let_emit(stage, {"lmap", emission("100lm")});
    EXPECT_EQ(to_text(unknown.error().diagnostics.back()), "error[USE0103]: unknown surface 'lmap'\nhint: did you mean "
                                                           "'lamp'? there are: floor, lamp, shade");
    EXPECT_FALSE(let_emit(stage, {"floor", emission("100nt")}));
    EXPECT_FALSE(stage.surfaces[0].emits);
}

TEST(EmissiveLights, FacesKnowTheirLight) {
    const Stage stage = stage_with(box, "500nt");
    const std::vector<Light> lights = emitted_by(stage);
    const EmittedLights emitted(stage, lights);
    EXPECT_FALSE(emitted.emits(0));
    EXPECT_TRUE(emitted.emits(1));
    for (int i = 0; i < 6; ++i) {
        const Panel side = face(box, i);
        const Hit hit = *first_hit(stage, {side.frame.origin + 0.1 * side.frame.z, -side.frame.z});
        EXPECT_EQ(emitted.at(hit), static_cast<std::uint32_t>(i));
    }
    EXPECT_FALSE(emitted.at(*first_hit(stage, {{3, 3, 1}, {0, 0, -1}})));
    EXPECT_TRUE(EmittedLights(stage, {}).empty());
}

} // namespace
} // namespace gonio
