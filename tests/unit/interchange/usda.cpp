// UsdLux: values that follow from the schema, transformations, and broken files.
#include <gonio/color/planckian.hpp>
#include <gonio/light/light_color.hpp>

#include "scenes.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

namespace gonio {

namespace {

using std::numbers::pi;
using test::failure_of;
using test::has_remark;
using test::number_of;
using test::scene_of;
using test::unit_of;

std::string usda(const std::string& prims, const std::string& unit = "1") {
    return "#usda 1.0\n(\n    metersPerUnit = " + unit + "\n    upAxis = \"Z\"\n)\n" + prims;
}

FoundLight light_of(const std::string& type, const std::string& attributes, const std::string& unit = "1",
                    const std::string& metadata = {}) {
    const FoundScene scene =
        scene_of(usda("def " + type + " \"lamp\" " + metadata + "{\n" + attributes + "\n}\n", unit));
    EXPECT_EQ(scene.lights.size(), 1U);
    return scene.lights.empty() ? FoundLight{} : scene.lights.front();
}

TEST(InterchangeUsd, DefaultsAreThoseOfTheSchema) {
    const FoundLight sphere = light_of("SphereLight", "");
    EXPECT_EQ(std::get<SphereShape>(*sphere.shape).radius.value, 0.5);
    EXPECT_EQ(number_of(sphere), 1.0);
    EXPECT_EQ(unit_of(sphere), "nt");
    const FoundLight rect = light_of("RectLight", "");
    EXPECT_EQ(std::get<RectShape>(*rect.shape).width.value, 1.0);
    EXPECT_LT(glm::distance(rect.direction, glm::dvec3(0.0, 0.0, -1.0)), 1e-15);
    const FoundLight sun = light_of("DistantLight", "");
    EXPECT_EQ(number_of(sun), 50000.0);
    EXPECT_EQ(unit_of(sun), "nt"); // over 0.53°: 3.36 lx
    EXPECT_NEAR(to_degrees(std::get<SunShape>(*sun.shape).diameter), 0.53, 1e-12);
    EXPECT_EQ(unit_of(light_of("DistantLight", "bool inputs:normalize = 1")), "lx");
    const FoundScene silent = scene_of("#usda 1.0\ndef SphereLight \"a\" {}\n");
    EXPECT_EQ(silent.meters_per_unit, 0.01);
    EXPECT_EQ(silent.diagnostics.size(), 2U); // unit and axis are assumed
}

TEST(InterchangeUsd, AmountIsIntensityExposureColourTemperature) {
    const FoundLight light = light_of("RectLight", "float inputs:intensity = 3\nfloat inputs:exposure = 4\n"
                                                   "color3f inputs:color = (0, 0, 1)");
    EXPECT_NEAR(number_of(light), 48.0 * rec709_luminance.z, 1e-12);
    const FoundLight warm = light_of("RectLight", "float intensity = 5\nbool enableColorTemperature = true\n"
                                                  "float colorTemperature = 3000"); // names before 21.02
    EXPECT_NEAR(number_of(warm), 5.0, 1e-12);
    EXPECT_EQ(warm.temperature->value, 3000.0);
    EXPECT_LT(glm::distance(warm.color, *parse_light_color("3000K")), 1e-12);
    EXPECT_EQ(light_of("RectLight", "float inputs:colorTemperature = 3000").temperature.has_value(), false);
}

TEST(InterchangeUsd, NormalizeDividesByTheWorldAreaInStageUnits) {
    const std::string scaled = "double3 xformOp:scale = (2, 2, 2)\nuniform token[] xformOpOrder = [\"xformOp:scale\"]\n"
                               "bool inputs:normalize = 1\nfloat inputs:intensity = 100\n";
    EXPECT_NEAR(number_of(light_of("RectLight", scaled)), 25.0, 1e-12);
    EXPECT_NEAR(number_of(light_of("DiskLight", scaled)), 100.0 / pi, 1e-12); // radius 1
    EXPECT_NEAR(number_of(light_of("SphereLight", scaled)), 100.0 / (4.0 * pi), 1e-12);
    const FoundLight centimeters = light_of("RectLight", scaled, "0.01");
    EXPECT_NEAR(number_of(centimeters), 25.0, 1e-12);
    EXPECT_NEAR(std::get<RectShape>(*centimeters.shape).width.value, 0.02, 1e-15);
    EXPECT_TRUE(has_remark(centimeters, "SCN0201"));
    // A cylinder of radius 1 and length 2 has 4π.
    const FoundLight cylinder = light_of("CylinderLight", scaled);
    EXPECT_NEAR(number_of(cylinder), 100.0 / (4.0 * pi), 1e-12);
    EXPECT_NEAR(std::get<CylinderShape>(*cylinder.shape).length.value, 2.0, 1e-12);
}

// The proposal for physical lighting.
TEST(InterchangeUsd, PowerReplacesIntensity) {
    const auto of = [](const std::string& type, const std::string& schema, const std::string& inputs) {
        return light_of(type,
                        "float inputs:intensity = 7\nfloat inputs:exposure = 3\nbool inputs:normalize = 1\n" + inputs,
                        "1", "(prepend apiSchemas = [" + schema + "])");
    };
    const std::string area = "\"PhotometricAreaLightAPI\"";
    for (const char* type : {"RectLight", "DiskLight", "SphereLight", "CylinderLight"}) {
        const FoundLight light = of(type, area, "float photometric:power = 800\ncolor3f inputs:color = (4, 2, 0.5)\n");
        EXPECT_EQ(number_of(light), 800.0) << type;
        EXPECT_EQ(unit_of(light), "lm") << type;
        EXPECT_NEAR(light.color.x / light.color.y, 2.0, 1e-12);
        EXPECT_TRUE(light.remarks.empty());
    }
    EXPECT_EQ(number_of(of("RectLight", area, "")), 1600.0) << "its fallback";
    const FoundLight both = of("RectLight", "\"RadiometricAreaLightAPI\", " + area,
                               "float radiometric:power = 3\nfloat photometric:power = 90\n");
    EXPECT_EQ(number_of(both), 90.0) << "photometric wins";
    const FoundLight sun =
        of("DistantLight", "\"PhotometricDistantLightAPI\"", "float photometric:illuminance = 8e4\n");
    EXPECT_EQ(number_of(sun), 8e4);
    EXPECT_EQ(unit_of(sun), "lx");
    const FoundLight spot =
        of("SphereLight", area + ", \"ShapingAPI\"",
           "bool treatAsPoint = 1\nfloat inputs:shaping:cone:angle = 30\nfloat photometric:power = 50\n");
    EXPECT_TRUE(std::holds_alternative<SpotShape>(*spot.shape));
    EXPECT_EQ(number_of(spot), 50.0);
    EXPECT_EQ(unit_of(spot), "lm");
}

TEST(InterchangeUsd, WattsHaveTheEfficacyOfTheirIlluminant) {
    const auto of = [](const std::string& inputs, std::optional<double> lumens_per_watt = {}) {
        SceneReadOptions options;
        options.lumens_per_watt = lumens_per_watt;
        const std::string text =
            "#usda 1.0\n(\nmetersPerUnit = 1\nupAxis = \"Z\"\n)\ndef RectLight \"l\" (prepend apiSchemas = "
            "[\"RadiometricAreaLightAPI\"])\n{\nfloat radiometric:power = 2\n" +
            inputs + "}\n";
        return test::scene_of(text, options).lights.at(0);
    };
    const FoundLight white = of("");
    EXPECT_NEAR(number_of(white), 2.0 * 204.0, 2.0);
    EXPECT_TRUE(has_remark(white, "SCN0201"));
    const FoundLight warm = of("token physical:illuminant = \"blackbody\"\nfloat inputs:colorTemperature = 2700\n");
    EXPECT_NEAR(number_of(warm), 2.0 * blackbody_efficacy(Kelvin(2700.0)).total_lm_per_w, 1e-9);
    EXPECT_LT(glm::distance(warm.color, *parse_light_color("2700K")), 1e-12);
    EXPECT_TRUE(has_remark(warm, "SCN0201"));
    const FoundLight given = of("", 100.0);
    EXPECT_EQ(number_of(given), 200.0);
    EXPECT_TRUE(given.remarks.empty());
    // Equal energy from 380 to 780 nm: 683 ∫V/400 nm.
    std::string pairs;
    for (int nm = 380; nm <= 780; nm += 5)
        pairs += (pairs.empty() ? "(" : ", (") + std::to_string(nm) + ", 3)";
    const FoundLight custom =
        of("token physical:illuminant = \"custom\"\nfloat2[] physical:customIlluminant = [" + pairs + "]\n");
    EXPECT_NEAR(number_of(custom), 2.0 * 683.0 * 106.857 / 400.0, 3.0);
    EXPECT_GT(custom.color.x, custom.color.y) << "E is warmer than D65";
    EXPECT_TRUE(custom.remarks.empty());
    const FoundLight absent = of("token physical:illuminant = \"custom\"\n");
    EXPECT_TRUE(has_remark(absent, "SCN0202"));
    EXPECT_TRUE(has_remark(absent, "SCN0201"));
    const FoundLight odd = of("token physical:illuminant = \"custom\"\n"
                              "float[] physical:customIlluminant = [400, 1, 500]\n");
    ASSERT_TRUE(has_remark(odd, "SCN0202"));
    EXPECT_NE(odd.remarks.front().message.find("not pairs"), std::string::npos) << odd.remarks.front().message;
}

TEST(InterchangeUsd, ShapingMakesSpotsAndProfiles) {
    const std::string point = "bool treatAsPoint = 1\nfloat inputs:radius = 2\nfloat inputs:intensity = 10\n";
    const FoundLight plain = light_of("SphereLight", point);
    EXPECT_TRUE(std::holds_alternative<PointShape>(*plain.shape));
    EXPECT_NEAR(number_of(plain), 40.0 * pi, 1e-12);
    EXPECT_EQ(unit_of(plain), "cd");
    const FoundLight spot = light_of("SphereLight", point + "float inputs:shaping:cone:angle = 40\n"
                                                            "float inputs:shaping:cone:softness = 0.25");
    const auto& cone = std::get<SpotShape>(*spot.shape);
    EXPECT_NEAR(to_degrees(cone.outer), 40.0, 1e-12);
    EXPECT_NEAR(to_degrees(cone.inner), 30.0, 1e-12);
    EXPECT_EQ(cone.falloff, Falloff::smoothstep_angle);
    // The API alone cuts the back half off.
    const FoundLight half = light_of("SphereLight", point, "1", "(prepend apiSchemas = [\"ShapingAPI\"])");
    EXPECT_NEAR(to_degrees(std::get<SpotShape>(*half.shape).outer), 90.0, 1e-12);
    const FoundLight profile = light_of("SphereLight", point + "asset inputs:shaping:ies:file = @./lamp.ies@");
    EXPECT_EQ(std::get<ProfileShape>(*profile.shape).file, "./lamp.ies");
    EXPECT_NEAR(profile.profile_scale, 40.0 * pi, 1e-12);
    const FoundLight normalized = light_of("SphereLight", point + "asset inputs:shaping:ies:file = @lamp.ies@\n"
                                                                  "bool inputs:shaping:ies:normalize = 1");
    EXPECT_NEAR(number_of(normalized), 160.0 * pi * pi, 1e-9);
    EXPECT_EQ(unit_of(normalized), "lm");
    EXPECT_FALSE(light_of("SphereLight", point + "float inputs:shaping:focus = 2").is_converted());
    EXPECT_FALSE(light_of("RectLight", "float inputs:shaping:cone:angle = 30").is_converted());
    EXPECT_TRUE(light_of("RectLight", "float inputs:shaping:cone:angle = 90").is_converted());
    EXPECT_FALSE(light_of("DomeLight", "").is_converted());
}

// OpenUSD, "Value Resolution": floating numbers change on a line, quaternions on an arc, all else jumps; outside the
// samples the nearest holds. A default holds where no time is given.
TEST(InterchangeUsd, ValuesAtATime) {
    const std::string text = usda(R"(def RectLight "moving" {
        float inputs:intensity = 7
        float inputs:intensity.timeSamples = { 20: 300, 10: 100, }
        bool inputs:normalize.timeSamples = { 10: 0, 20: 1 }
        float inputs:width.timeSamples = { 10: 2, 20: 4 }
        double3 xformOp:translate.timeSamples = { 10: (0, 0, 0), 20: (10, 0, 0) }
        quatf xformOp:orient.timeSamples = { 10: (1, 0, 0, 0), 20: (0.70710678, 0.70710678, 0, 0) }
        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:orient"]
    })");
    const auto at = [&](std::optional<double> time) {
        SceneReadOptions options;
        options.time = time;
        return scene_of(text, options);
    };
    const FoundLight middle = at(15.0).lights.at(0);
    EXPECT_NEAR(number_of(middle), 200.0, 1e-12); // not yet normalized
    EXPECT_NEAR(std::get<RectShape>(*middle.shape).width.value, 3.0, 1e-12);
    EXPECT_LT(glm::distance(middle.position, glm::dvec3(5.0, 0.0, 0.0)), 1e-12);
    EXPECT_LT(glm::distance(middle.direction, glm::dvec3(0.0, std::sin(pi / 4.0), -std::cos(pi / 4.0))), 1e-7);
    EXPECT_TRUE(middle.remarks.empty());
    EXPECT_NEAR(number_of(at(99.0).lights.at(0)), 300.0 / 4.0, 1e-12);
    EXPECT_NEAR(number_of(at(-1.0).lights.at(0)), 100.0, 1e-12);
    const FoundScene untimed = at(std::nullopt);
    EXPECT_NEAR(number_of(untimed.lights.at(0)), 7.0, 1e-12);
    EXPECT_NEAR(std::get<RectShape>(*untimed.lights.at(0).shape).width.value, 2.0, 1e-12);
    ASSERT_EQ(untimed.lights.at(0).remarks.size(), 1U); // one for all that changes
    EXPECT_EQ(untimed.lights.at(0).remarks[0].message,
              "'normalize' and 'width' change over time: the first samples are taken");
    EXPECT_EQ(untimed.diagnostics.size(), 1U); // its place changes too
}

// No sample is before or after such a time.
TEST(InterchangeUsd, TimesAreFinite) {
    for (const std::string time : {"1x", "-inf", "-nan", "1e999"})
        EXPECT_EQ(
            failure_of(usda("def RectLight \"a\" { float inputs:intensity.timeSamples = { " + time + ": 5 } }")).code,
            "SCN0105")
            << time;
    // In any order, and the first of two at the same time.
    SceneReadOptions options;
    options.time = 1.5;
    const FoundScene scene = scene_of(
        usda("def RectLight \"a\" { float inputs:intensity.timeSamples = { 2: 7, 1: 5, 1: 9 } }"), options, "usd");
    EXPECT_EQ(number_of(scene.lights.at(0)), 6.0);
}

TEST(InterchangeUsd, TransformationsOpsParentsAndResets) {
    const FoundScene scene = scene_of(usda(R"(def Xform "rig" {
        double3 xformOp:translate = (1, 2, 3)
        float xformOp:rotateX:tilt = 90
        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateX:tilt"]
        def RectLight "a" { }
        def RectLight "b" {
            double3 xformOp:translate = (0, 0, 1)
            uniform token[] xformOpOrder = ["!resetXformStack!", "xformOp:translate", "!invert!xformOp:translate"]
        }
        def RectLight "c" { float3 xformOp:rotateXYZ = (0, 0, 90)
            uniform token[] xformOpOrder = ["xformOp:rotateXYZ"] }
        def RectLight "d" { matrix4d xformOp:transform = ( (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (7, 8, 9, 1) )
            uniform token[] xformOpOrder = ["!resetXformStack!", "xformOp:transform"] }
    })"));
    ASSERT_EQ(scene.lights.size(), 4U);
    EXPECT_EQ(scene.lights[0].place, "/rig/a");
    EXPECT_LT(glm::distance(scene.lights[0].position, glm::dvec3(1.0, 2.0, 3.0)), 1e-14);
    EXPECT_LT(glm::distance(scene.lights[0].direction, glm::dvec3(0.0, 1.0, 0.0)), 1e-14); // −Z by 90° about X
    EXPECT_LT(glm::distance(scene.lights[1].position, glm::dvec3(0.0)), 1e-14);
    EXPECT_LT(glm::distance(scene.lights[2].up, glm::dvec3(-1.0, 0.0, 0.0)), 1e-14);
    EXPECT_LT(glm::distance(scene.lights[3].position, glm::dvec3(7.0, 8.0, 9.0)), 1e-14);
}

TEST(InterchangeUsd, WhatIsNotShownOrMissingIsSaid) {
    const FoundScene scene = scene_of(usda(R"(class "c" { def SphereLight "a" {} }
over "o" { def SphereLight "b" {} }
def Xform "off" (active = false) { def SphereLight "c" {} }
def Xform "hidden" { token visibility = "invisible" def SphereLight "d" {} }
def "ref" ( prepend references = @lamp.usda@</lamp> (offset = 1) ) { }
def "set" ( variants = { string v = "x" } prepend variantSets = "v" ) {
    variantSet "v" = { "x" { def SphereLight "e" {} } "y" ( ) { def SphereLight "f" {} } }
    rel material:binding = </a/b> ( bindMaterialAs = "x" )
    rel many = [ </a>, </b> ]
}
def SphereLight "moving" { float inputs:intensity.timeSamples = { 2: 5, 1: 4, } custom dictionary d = { string s = "}" } })"));
    ASSERT_EQ(scene.lights.size(), 6U);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_TRUE(has_remark(scene.lights[i], "SCN0204")) << i;
    EXPECT_EQ(scene.lights[4].place, "/set/e"); // of the variant that is selected
    EXPECT_TRUE(scene.lights[4].is_converted());
    EXPECT_EQ(number_of(scene.lights[5]), 4.0);
    EXPECT_TRUE(has_remark(scene.lights[5], "SCN0201"));
    ASSERT_EQ(scene.diagnostics.size(), 1U);
    EXPECT_EQ(scene.diagnostics[0].code, "SCN0107");
    EXPECT_EQ(scene.diagnostics[0].location.line, 10U);
}

TEST(InterchangeUsd, BrokenFilesFailWithTheirPlace) {
    const auto code = [](const std::string& text) { return failure_of(usda(text)).code; };
    EXPECT_EQ(code("def SphereLight \"a\" {"), "SCN0102");
    EXPECT_EQ(code("def SphereLight \"a"), "SCN0102");
    EXPECT_EQ(code("}"), "SCN0102");
    EXPECT_EQ(code("def SphereLight \"a\" { float inputs:intensity = }"), "SCN0102");
    EXPECT_EQ(code("def SphereLight \"a\" { float inputs:intensity = (1, 2) }"), "SCN0105");
    EXPECT_EQ(code("def SphereLight \"a\" { float inputs:intensity = nan }"), "SCN0105");
    EXPECT_EQ(code("def SphereLight \"a\" { float inputs:intensity = -inf }"), "SCN0105");
    EXPECT_EQ(code("def SphereLight \"a\" { float inputs:intensity = 1e999 }"), "SCN0105");
    EXPECT_EQ(code("def SphereLight \"a\" { color3f inputs:color = (1, 2) }"), "SCN0105");
    EXPECT_EQ(code("def SphereLight \"a\" { uniform token[] xformOpOrder = [\"xformOp:gone\"] }"), "SCN0103");
    EXPECT_EQ(code("def SphereLight \"a\" { matrix4d xformOp:transform = (1) uniform token[] xformOpOrder = "
                   "[\"xformOp:transform\"] }"),
              "SCN0105");
    std::string deep;
    for (int i = 0; i < 1000; ++i)
        deep += "def \"a\" {\n";
    EXPECT_EQ(code(deep), "SCN0108");
    EXPECT_EQ(code("def \"a\" { int[] b = " + std::string(1000, '[') + "}"), "SCN0108");
    EXPECT_EQ(failure_of("#usda 1.0\n\n  5").location.line, 3U);
    EXPECT_EQ(failure_of("#usda 1.0\n( metersPerUnit = 0 )").code, "SCN0105");
}

} // namespace

} // namespace gonio
