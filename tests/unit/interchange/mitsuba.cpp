// Lights of Mitsuba 3: values that follow from its documents, and broken files.
#include <gonio/light/light_color.hpp>

#include "scenes.hpp"

#include <glm/geometric.hpp>

#include <string>

namespace gonio {

namespace {

using test::failure_of;
using test::has_remark;
using test::number_of;
using test::scene_of;
using test::unit_of;

FoundLight light_of(const std::string& text, const SceneReadOptions& options = {}) {
    const FoundScene scene = scene_of("<scene version=\"3.0.0\">\n" + text + "\n</scene>", options);
    EXPECT_EQ(scene.lights.size(), 1U);
    return scene.lights.empty() ? FoundLight{} : scene.lights.front();
}

TEST(InterchangeMitsuba, PunctualLights) {
    const FoundLight point = light_of(R"(<!-- key --><emitter type="point"><point name="position" x="1" y="2" z="3"/>
        <rgb name="intensity" value="0, 0, 10"/></emitter>)");
    EXPECT_EQ(point.name, "key");
    EXPECT_EQ(point.position, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_NEAR(number_of(point), 10.0 * rec709_luminance.z, 1e-12);
    SceneReadOptions options;
    options.lumens_per_watt = 180.0;
    EXPECT_NEAR(number_of(light_of(R"(<emitter type="point"><rgb name="intensity" value="2"/></emitter>)", options)),
                360.0, 1e-12);
    const FoundLight spot = light_of(
        R"(<emitter type="spot"><transform name="to_world"><lookat origin="0,0,3" target="0,0,0" up="0,1,0"/></transform></emitter>)");
    const auto& cone = std::get<SpotShape>(*spot.shape);
    EXPECT_NEAR(to_degrees(cone.outer), 20.0, 1e-12);
    EXPECT_NEAR(to_degrees(cone.inner), 15.0, 1e-12);
    EXPECT_EQ(cone.falloff, Falloff::linear_angle);
    EXPECT_LT(glm::distance(spot.direction, glm::dvec3(0.0, 0.0, -1.0)), 1e-14);
    EXPECT_EQ(spot.position, glm::dvec3(0.0, 0.0, 3.0));
    const FoundLight sun = light_of(
        R"(<emitter type="directional"><vector name="direction" value="0,0,-2"/><float name="irradiance" value="7"/></emitter>)");
    EXPECT_EQ(unit_of(sun), "lx");
    EXPECT_EQ(number_of(sun), 7.0);
    EXPECT_LT(glm::distance(sun.direction, glm::dvec3(0.0, 0.0, -1.0)), 1e-14);
    EXPECT_FALSE(light_of(R"(<emitter type="envmap"/>)").is_converted());
    EXPECT_FALSE(
        light_of(R"(<emitter type="point"><blackbody name="intensity" temperature="3000"/></emitter>)").is_converted());
}

TEST(InterchangeMitsuba, ShapesThatEmit) {
    const auto area = [](const std::string& shape, const std::string& inside) {
        return light_of("<shape type=\"" + shape + "\">" + inside +
                        R"(<emitter type="area"><rgb name="radiance" value="500"/></emitter></shape>)");
    };
    const FoundLight rect = area("rectangle", R"(<transform name="to_world"><scale x="0.5" y="0.25"/>
        <rotate x="1" angle="180"/><translate z="2"/></transform>)");
    EXPECT_EQ(std::get<RectShape>(*rect.shape).width.value, 1.0);
    EXPECT_EQ(std::get<RectShape>(*rect.shape).height.value, 0.5);
    EXPECT_LT(glm::distance(rect.direction, glm::dvec3(0.0, 0.0, -1.0)), 1e-14);
    EXPECT_LT(glm::distance(rect.position, glm::dvec3(0.0, 0.0, 2.0)), 1e-14);
    EXPECT_EQ(number_of(rect), 500.0);
    EXPECT_EQ(unit_of(rect), "nt");
    EXPECT_LT(glm::distance(area("disk", R"(<boolean name="flip_normals" value="true"/>)").direction,
                            glm::dvec3(0.0, 0.0, -1.0)),
              1e-14);
    EXPECT_EQ(std::get<SphereShape>(*area("sphere", R"(<float name="radius" value="0.2"/>)").shape).radius.value, 0.2);
    EXPECT_FALSE(area("obj", "").is_converted());
    EXPECT_FALSE(area("rectangle", R"(<transform name="to_world"><matrix value="1 1 0 0 1 0 0 0 1"/></transform>)")
                     .is_converted());
}

TEST(InterchangeMitsuba, DefaultsReferencesAndIncludes) {
    SceneReadOptions options;
    options.read_beside = [](const std::string& name) -> Result<std::string> {
        if (name == "more.xml") return std::string("<scene version=\"3.0.0\"><emitter type=\"point\"/></scene>");
        if (name == "loop.xml") return std::string("<scene version=\"3.0.0\"><include filename=\"loop.xml\"/></scene>");
        return fail(Failure::io, "no such file");
    };
    const FoundScene scene = scene_of(R"(<scene version="3.0.0"><default name="power" value="30"/>
        <emitter type="area" id="glow"><rgb name="radiance" value="$power"/></emitter>
        <shape type="sphere"><ref id="glow"/></shape><include filename="more.xml"/></scene>)",
                                      options);
    ASSERT_EQ(scene.lights.size(), 2U);
    EXPECT_EQ(number_of(scene.lights[0]), 30.0);
    const Result<FoundScene> loop =
        read_scene_lights("<scene version=\"3.0.0\"><include filename=\"loop.xml\"/></scene>", "scene", options);
    ASSERT_FALSE(loop.has_value());
    EXPECT_EQ(loop.error().diagnostics.back().code, "SCN0104");
}

TEST(InterchangeMitsuba, BrokenFilesFailWithTheirPlace) {
    const auto code = [](const std::string& text) { return failure_of(text, "mitsuba").code; };
    EXPECT_EQ(code("<scene><emitter"), "SCN0102");
    EXPECT_EQ(code("<mesh/>"), "SCN0101");
    EXPECT_EQ(code(R"(<scene><emitter type="point"><rgb name="intensity" value="1 2"/></emitter></scene>)"), "SCN0105");
    EXPECT_EQ(code(R"(<scene><emitter type="point"><rgb name="intensity" value="nan"/></emitter></scene>)"), "SCN0105");
    EXPECT_EQ(
        code(
            R"(<scene><emitter type="spot"><transform name="to_world"><matrix value="1 2 3"/></transform></emitter></scene>)"),
        "SCN0105");
    std::string deep;
    for (int i = 0; i < 100; ++i)
        deep += "<scene>";
    EXPECT_NE(code(deep), "");
    EXPECT_EQ(failure_of("<scene>\n\n<emitter type=\"point\"><rgb name=\"intensity\" value=\"x\"/></emitter></scene>")
                  .location.line,
              3U);
}

} // namespace

} // namespace gonio
