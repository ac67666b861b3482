#include <gonio/light/light.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/light/photometry.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

#include "../web/webs.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gonio {
namespace {

using std::numbers::pi;

double convert(const Shape& shape, const char* from, const char* to) {
    const Result<Emission> emission = emission_of(shape, parse_photometric_value(from).value());
    return express(shape, emission.value(), parse_photometric_unit(to).value()).value();
}

Shape sphere(double r) {
    return SphereShape{Meters(r)};
}

Shape measured() {
    return ProfileShape{"test.ies", std::make_shared<const Web>(test::random_web(
                                        Symmetry::quadrant, test::steps(0, 90, 7), test::steps(0, 90, 19), 5))};
}

TEST(Photometry, SphereOf800LumensAnd3Centimetres) {
    // 800/(4π² 0.03²) with 30 digits
    EXPECT_NEAR(convert(sphere(0.03), "800lm", "nt"), 22515.818587186169, 22515.818587186169 * 4e-16);
    EXPECT_NEAR(convert(sphere(0.03), "800lm", "cd"), 200.0 / pi, 1e-13);
}

TEST(Photometry, MatchesIntegratedEmission) {
    // Flux of a Lambertian sphere: π L times its surface; of a point: I over the whole sphere.
    EXPECT_NEAR(convert(sphere(0.25), "1000nt", "lm"), pi * 1000.0 * 4.0 * pi * 0.25 * 0.25, 1e-9);
    EXPECT_NEAR(convert(PointShape{}, "100cd", "lm"), 400.0 * pi, 1e-12);
    const Shape shape = measured();
    const Web& web = *std::get<ProfileShape>(shape).web;
    const double cd = peak(web).intensity.value;
    EXPECT_NEAR(convert(shape, (shortest(cd) + "cd").c_str(), "lm"), flux(web).value, 1e-10 * flux(web).value);
}

TEST(Photometry, InverseSquareIsExactForASphere) {
    // E = πL sin²σ: on contact the whole hemisphere is filled and E = πL.
    EXPECT_NEAR(convert(sphere(0.5), "1000nt", "lx@0.5m"), 1000.0 * pi, 1e-10);
    EXPECT_NEAR(convert(PointShape{}, "100cd", "lx@2m"), 25.0, 1e-14);
    EXPECT_NEAR(convert(PointShape{}, "100cd", "fc@10ft"), 1.0, 1e-14);
}

TEST(Photometry, WattsNeedAnEfficacy) {
    EXPECT_NEAR(convert(PointShape{}, "60W@90lm/W", "lm"), 5400.0, 1e-11);
    EXPECT_NEAR(convert(PointShape{}, "1W@683", "lm"), 683.0, 1e-12);
    EXPECT_FALSE(parse_photometric_value("60W"));
    EXPECT_FALSE(parse_photometric_value("60W@0"));
    EXPECT_FALSE(parse_photometric_value("60W@700"));
}

TEST(Photometry, WhatHasNoMeaningIsRefused) {
    const auto refused = [](const Shape& shape, const char* from, const char* to) {
        const auto value = parse_photometric_value(from);
        if (!value) return true;
        const auto emission = emission_of(shape, *value);
        if (!emission) return true;
        const auto unit = parse_photometric_unit(to);
        return !unit || !express(shape, *emission, *unit);
    };
    EXPECT_TRUE(refused(PointShape{}, "800lm", "nt"));
    EXPECT_TRUE(refused(PointShape{}, "5nt", "lm"));
    EXPECT_TRUE(refused(measured(), "800lm", "nt"));
    EXPECT_TRUE(refused(sphere(0.5), "800lm", "lx@40cm")); // inside
    EXPECT_TRUE(refused(PointShape{}, "800lm", "lx"));
    EXPECT_TRUE(refused(PointShape{}, "800lm", "cd@2m"));
    EXPECT_TRUE(refused(PointShape{}, "800lm", "lx@0m"));
    EXPECT_TRUE(refused(PointShape{}, "-800lm", "cd"));
    EXPECT_TRUE(refused(PointShape{}, "800lm", "K"));
    EXPECT_TRUE(refused(PointShape{}, "3m", "cd"));
    EXPECT_TRUE(refused(sphere(0.5), "0lm", "ev"));
    EXPECT_FALSE(refused(sphere(0.5), "-3ev", "nt"));
}

TEST(Shape, GrammarAndItsErrors) {
    EXPECT_TRUE(std::holds_alternative<PointShape>(parse_shape("point").value()));
    EXPECT_DOUBLE_EQ(std::get<SphereShape>(parse_shape("sphere:r=3cm").value()).radius.value, 0.03);
    EXPECT_EQ(std::get<ProfileShape>(parse_shape("ies:a,b=c:d.ies").value()).file, "a,b=c:d.ies");
    for (const char* text : {"", "point:r=1m", "sphere", "sphere:r=3", "sphere:r=0m", "sphere:r=-1m", "sphere:r=1lm",
                             "sphere:r=1m,q=2", "ies", "ies:", "cube:a=1m"})
        EXPECT_FALSE(parse_shape(text)) << text;
}

TEST(LightColor, HasLuminanceOne) {
    for (const char* text : {"d65", "#ffd9a0", "rgb(1,0.5,0.25)", "rgb(0,0,3)"}) {
        const auto rgb = parse_light_color(text);
        ASSERT_TRUE(rgb) << text;
        EXPECT_NEAR(glm::dot(*rgb, rec709_luminance), 1.0, 1e-15);
    }
    for (const char* text : {"", "#fff", "#gggggg", "rgb(1,2)", "rgb(1,2,3,4)", "rgb(0,0,0)", "rgb(-1,1,1)", "white"})
        EXPECT_FALSE(parse_light_color(text)) << text;
}

TEST(Light, AProfileShinesAsMeasuredOrAsAsked) {
    Diagnostics diagnostics;
    LightDescription description;
    description.shape = measured();
    const Web& web = *std::get<ProfileShape>(description.shape).web;
    const Light plain = resolve_light(description, diagnostics).value();
    EXPECT_NEAR(plain.intensity_towards({0.3, 0.2, -1}).value, web.candela({0.3, 0.2, -1}), 1e-9);
    description.intensity = parse_photometric_value("1000lm").value();
    const Light scaled = resolve_light(description, diagnostics).value();
    EXPECT_NEAR(scaled.web_scale * flux(web).value, 1000.0, 1e-9);
}

TEST(Light, TurnsWithItsFrame) {
    Diagnostics diagnostics;
    LightDescription description;
    description.shape = measured();
    const Light hanging = resolve_light(description, diagnostics).value();
    description.rotation = degrees(90);
    const Light turned = resolve_light(description, diagnostics).value();
    // Turned from C0 towards C90: what went along +X goes along +Y.
    EXPECT_NEAR(turned.intensity_towards({0.0, 1.0, -1.0}).value, hanging.intensity_towards({1.0, 0.0, -1.0}).value,
                1e-9);
    description.rotation = degrees(0);
    description.direction = {0, 1, 0};
    description.up = {0, 0, 1};
    const Light aimed = resolve_light(description, diagnostics).value();
    EXPECT_NEAR(aimed.intensity_towards({0, 1, 0}).value, hanging.intensity_towards({0, 0, -1}).value, 1e-9);
    // C90 points along `up`.
    EXPECT_NEAR(aimed.intensity_towards({0, 1, 0.5}).value, hanging.intensity_towards({0, 0.5, -1}).value, 1e-9);
}

TEST(Light, RefusesWhatCannotBePlaced) {
    Diagnostics diagnostics;
    LightDescription description;
    description.shape = PointShape{};
    EXPECT_FALSE(resolve_light(description, diagnostics)); // no intensity
    description.intensity = parse_photometric_value("1cd").value();
    EXPECT_TRUE(resolve_light(description, diagnostics));
    description.direction = {0, 0, 0};
    EXPECT_FALSE(resolve_light(description, diagnostics));
    description.direction = {0, 0, -1};
    description.position = {0, 0, NAN};
    EXPECT_FALSE(resolve_light(description, diagnostics));
    description.position = {};
    description.range = Meters(0);
    EXPECT_FALSE(resolve_light(description, diagnostics));
}

} // namespace
} // namespace gonio
