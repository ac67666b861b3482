// Lights that scripts list inside Unreal and Unity.
#include "scenes.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <string>

namespace gonio {

namespace {

using std::numbers::pi;
using test::failure_of;
using test::has_remark;
using test::number_of;
using test::scene_of;
using test::unit_of;

FoundLight light_of(const std::string& program, const std::string& light) {
    const FoundScene scene =
        scene_of(R"({"schema":"gonio.engine-lights/1","program":")" + program + R"(","lights":[{)" + light + "}]}");
    EXPECT_EQ(scene.format, "engine-json");
    EXPECT_EQ(scene.lights.size(), 1U);
    return scene.lights.empty() ? FoundLight{} : scene.lights.front();
}

FoundLight unreal(const std::string& kind, const std::string& light) {
    return light_of("unreal", R"("name":"key","kind":")" + kind +
                                  R"(","position":[100,200,300],"forward":[0,0,-1],"up":[1,0,0],)" + light);
}

FoundLight unity(const std::string& kind, const std::string& light) {
    return light_of("unity", R"("name":"key","kind":")" + kind +
                                 R"(","position":[1,2,3],"forward":[0,-1,0],"up":[0,0,1],)" + light);
}

TEST(InterchangeEngines, UnrealsUnits) {
    const FoundLight point =
        unreal("PointLight", R"("intensity":800,"intensity_units":"LUMENS","attenuation_radius":1000)");
    EXPECT_NEAR(number_of(point), 800.0 / (4.0 * pi), 1e-12);
    EXPECT_LT(glm::distance(point.position, glm::dvec3(1.0, -2.0, 3.0)), 1e-14); // left-handed, centimetres
    EXPECT_LT(glm::distance(point.direction, glm::dvec3(0.0, 0.0, -1.0)), 1e-14);
    EXPECT_LT(glm::distance(point.up, glm::dvec3(1.0, 0.0, 0.0)), 1e-14);
    EXPECT_EQ(point.range->value, 10.0);
    EXPECT_NEAR(number_of(unreal("PointLight", R"("intensity":5000,"intensity_units":"UNITLESS")")), 8.0, 1e-12);
    EXPECT_EQ(number_of(unreal("PointLight", R"("intensity":50,"intensity_units":"CANDELAS")")), 50.0);
    EXPECT_FALSE(unreal("PointLight", R"("intensity":5,"intensity_units":"EV")").is_converted());
    const FoundLight spot = unreal(
        "SpotLight", R"("intensity":1000,"intensity_units":"LUMENS","inner_cone_angle":20,"outer_cone_angle":40)");
    EXPECT_NEAR(number_of(spot), 1000.0 / (2.0 * pi * (1.0 - std::cos(40.0 / 180.0 * pi))), 1e-9);
    EXPECT_EQ(std::get<SpotShape>(*spot.shape).falloff, Falloff::frostbite);
    const FoundLight rect =
        unreal("RectLight", R"("intensity":300,"intensity_units":"LUMENS","source_width":60,"source_height":30)");
    EXPECT_NEAR(number_of(rect), 300.0 / pi, 1e-12);
    EXPECT_NEAR(std::get<RectShape>(*rect.shape).width.value, 0.6, 1e-15);
    EXPECT_EQ(unit_of(unreal("DirectionalLight", R"("intensity":100000,"light_source_angle":0.5357)")), "lx");
    const FoundLight far =
        unreal("PointLight", R"("intensity":5,"intensity_units":"UNITLESS","use_inverse_squared_falloff":false)");
    EXPECT_TRUE(has_remark(far, "SCN0308"));
    EXPECT_FALSE(far.is_converted());
    const FoundLight profile = unreal(
        "PointLight",
        R"("intensity":7,"intensity_units":"CANDELAS","ies":"lamp.ies","use_ies_brightness":true,"ies_brightness_scale":2)");
    EXPECT_EQ(profile.profile_scale, 2.0);
    EXPECT_FALSE(profile.intensity.has_value());
    EXPECT_EQ(number_of(unreal("PointLight", R"("intensity":7,"intensity_units":"CANDELAS","ies":"lamp.ies")")), 7.0);
    EXPECT_FALSE(unreal("PointLight", R"("intensity":7,"intensity_units":"CANDELAS","visible":false)").is_converted());
}

TEST(InterchangeEngines, UnitysStoredAmounts) {
    const FoundLight spot =
        unity("Spot", R"("intensity":900,"unit":"Lumen","spot_angle":80,"inner_spot_angle":50,"range":12)");
    EXPECT_EQ(number_of(spot), 900.0);
    EXPECT_EQ(unit_of(spot), "cd"); // the unit is only displayed
    EXPECT_NEAR(to_degrees(std::get<SpotShape>(*spot.shape).outer), 40.0, 1e-12);
    EXPECT_NEAR(to_degrees(std::get<SpotShape>(*spot.shape).inner), 25.0, 1e-12);
    EXPECT_LT(glm::distance(spot.position, glm::dvec3(1.0, 3.0, 2.0)), 1e-14);
    EXPECT_LT(glm::distance(spot.direction, glm::dvec3(0.0, 0.0, -1.0)), 1e-14);
    EXPECT_LT(glm::distance(spot.up, glm::dvec3(0.0, 1.0, 0.0)), 1e-14);
    const FoundLight rect = unity("Rectangle", R"("intensity":3000,"area_size":[0.6,0.3])");
    EXPECT_EQ(unit_of(rect), "nt");
    EXPECT_EQ(std::get<RectShape>(*rect.shape).width.value, 0.6);
    EXPECT_EQ(unit_of(unity("Directional", R"("intensity":1e5)")), "lx");
    EXPECT_FALSE(unity("Tube", R"("intensity":5,"area_size":[1,0.1])").is_converted());
    EXPECT_EQ(unity("Point", R"("intensity":5,"use_temperature":true,"temperature":3000)").temperature->value, 3000.0);
}

TEST(InterchangeEngines, BrokenListsFail) {
    const auto code = [](const std::string& text) { return failure_of(text, "engine-json").code; };
    EXPECT_EQ(code("{"), "SCN0102");
    EXPECT_EQ(code("{}"), "SCN0101");
    EXPECT_EQ(code(R"({"schema":"gonio.engine-lights/2"})"), "SCN0101");
    EXPECT_EQ(code(R"({"schema":"gonio.engine-lights/1","program":"doom","lights":[]})"), "SCN0101");
    EXPECT_EQ(code(R"({"schema":"gonio.engine-lights/1","program":"unity","lights":{}})"), "SCN0105");
    EXPECT_EQ(code(R"({"schema":"gonio.engine-lights/1","program":"unity","lights":[1]})"), "SCN0105");
    EXPECT_EQ(code(R"({"schema":"gonio.engine-lights/1","program":"unity","lights":[{"intensity":"x"}]})"), "SCN0105");
    EXPECT_EQ(code(R"({"schema":"gonio.engine-lights/1","program":"unity","lights":[{"color":[1,2]}]})"), "SCN0105");
    EXPECT_FALSE(unity("Spot", R"("intensity":5,"spot_angle":200)").is_converted());
    EXPECT_FALSE(light_of("unity", R"("kind":"Point","intensity":5)").is_converted()); // without a direction
}

} // namespace

} // namespace gonio
