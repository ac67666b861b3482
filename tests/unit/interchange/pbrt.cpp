// Lights of pbrt-v4: values that follow from its documents, and broken files.
#include <gonio/light/light_color.hpp>

#include "scenes.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>

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

FoundLight light_of(const std::string& text) {
    const FoundScene scene = scene_of(text, {}, "pbrt");
    EXPECT_EQ(scene.lights.size(), 1U);
    return scene.lights.empty() ? FoundLight{} : scene.lights.front();
}

TEST(InterchangePbrt, PunctualLightsAreInCandela) {
    const FoundLight point = light_of("LightSource \"point\" \"float scale\" 60 \"point3 from\" [1 2 3]");
    EXPECT_EQ(number_of(point), 60.0);
    EXPECT_EQ(unit_of(point), "cd");
    EXPECT_EQ(point.position, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_NEAR(number_of(light_of("LightSource \"point\" \"float power\" [800]")), 800.0 / (4.0 * pi), 1e-12);
    EXPECT_NEAR(number_of(light_of("LightSource \"point\" \"rgb I\" [0 0 2] \"float scale\" 10")),
                20.0 * rec709_luminance.z, 1e-12);
    const FoundLight warm = light_of("LightSource \"point\" \"blackbody I\" 2700 \"float scale\" 10");
    EXPECT_EQ(number_of(warm), 10.0);
    EXPECT_EQ(warm.temperature->value, 2700.0);
    EXPECT_LT(glm::distance(warm.color, *parse_light_color("2700K")), 1e-12);
    EXPECT_TRUE(has_remark(light_of("LightSource \"point\" \"spectrum I\" \"lamp.spd\""), "SCN0201"));
}

TEST(InterchangePbrt, SpotsAndDistantLights) {
    const FoundLight spot =
        light_of("Translate 0 0 5\nLightSource \"spot\" \"point3 from\" [1 0 0] \"point3 to\" [1 0 -1]");
    EXPECT_EQ(spot.position, glm::dvec3(1.0, 0.0, 5.0));
    EXPECT_LT(glm::distance(spot.direction, glm::dvec3(0.0, 0.0, -1.0)), 1e-14);
    const auto& cone = std::get<SpotShape>(*spot.shape);
    EXPECT_NEAR(to_degrees(cone.outer), 30.0, 1e-12);
    EXPECT_NEAR(to_degrees(cone.inner), 25.0, 1e-12);
    EXPECT_EQ(cone.falloff, Falloff::smoothstep_cos);
    EXPECT_EQ(unit_of(light_of("LightSource \"spot\" \"float power\" 500")), "lm");
    EXPECT_FALSE(light_of("LightSource \"spot\" \"float coneangle\" 120").is_converted());
    const FoundLight sun = light_of("LightSource \"distant\" \"float illuminance\" 1e5");
    EXPECT_EQ(number_of(sun), 1e5);
    EXPECT_EQ(unit_of(sun), "lx");
    EXPECT_LT(glm::distance(sun.direction, glm::dvec3(0.0, 0.0, 1.0)), 1e-14);
}

TEST(InterchangePbrt, TransformationsNestAndEndWithTheWorld) {
    const FoundScene scene = scene_of("LookAt 9 9 9 0 0 0 0 0 1\nCamera \"perspective\" \"float fov\" 45\nWorldBegin\n"
                                      "AttributeBegin # key\nTranslate 1 0 0\nAttributeBegin\nScale 2 2 2\n"
                                      "LightSource \"point\" \"point3 from\" [0 1 0]\nAttributeEnd\n"
                                      "LightSource \"point\"\nAttributeEnd\nLightSource \"point\"\n");
    ASSERT_EQ(scene.lights.size(), 3U);
    EXPECT_EQ(scene.lights[0].position, glm::dvec3(1.0, 2.0, 0.0));
    EXPECT_EQ(scene.lights[1].position, glm::dvec3(1.0, 0.0, 0.0));
    EXPECT_EQ(scene.lights[1].name, "key");
    EXPECT_EQ(scene.lights[2].position, glm::dvec3(0.0, 0.0, 0.0));
    SceneReadOptions options;
    options.up = 'y';
    options.unit = Meters(0.01);
    EXPECT_EQ(scene_of("WorldBegin\nLightSource \"point\" \"point3 from\" [0 100 0]", options).lights[0].position,
              glm::dvec3(0.0, 0.0, 1.0));
}

TEST(InterchangePbrt, AreasAreInNitsAndFaceTheirNormal) {
    const auto area = [](const std::string& shape, const std::string& more = {}) {
        return light_of("WorldBegin\nAreaLightSource \"diffuse\" \"float scale\" 3000" + more + "\n" + shape);
    };
    const FoundLight disk = area("Shape \"disk\" \"float radius\" 0.5");
    EXPECT_EQ(number_of(disk), 3000.0);
    EXPECT_EQ(unit_of(disk), "nt");
    EXPECT_EQ(std::get<DiskShape>(*disk.shape).radius.value, 0.5);
    EXPECT_LT(glm::distance(disk.direction, glm::dvec3(0.0, 0.0, 1.0)), 1e-14);
    EXPECT_LT(glm::distance(area("ReverseOrientation Shape \"disk\"").direction, glm::dvec3(0.0, 0.0, -1.0)), 1e-14);
    EXPECT_TRUE(std::get<DiskShape>(*area("Shape \"disk\"", " \"bool twosided\" true").shape).two_sided);
    EXPECT_EQ(std::get<SphereShape>(*area("Scale 2 2 2 Shape \"sphere\" \"float radius\" 0.1").shape).radius.value,
              0.2);
    EXPECT_FALSE(area("Scale 2 1 1 Shape \"sphere\"").is_converted());
    EXPECT_EQ(unit_of(area("Shape \"sphere\"", " \"float power\" 800")), "lm");
    const FoundLight quad = area("Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point3 P\" "
                                 "[-1 -2 3  1 -2 3  1 2 3  -1 2 3]");
    EXPECT_EQ(std::get<RectShape>(*quad.shape).width.value, 4.0);
    EXPECT_EQ(std::get<RectShape>(*quad.shape).height.value, 2.0);
    EXPECT_LT(glm::distance(quad.position, glm::dvec3(0.0, 0.0, 3.0)), 1e-14);
    EXPECT_LT(glm::distance(quad.direction, glm::dvec3(0.0, 0.0, 1.0)), 1e-14);
    const FoundLight turned = area("Scale -1 1 1 Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point3 P\" "
                                   "[-1 -2 3  1 -2 3  1 2 3  -1 2 3]");
    EXPECT_LT(glm::distance(turned.direction, glm::dvec3(0.0, 0.0, 1.0)), 1e-14); // it swaps the handedness
    EXPECT_FALSE(
        area("Shape \"trianglemesh\" \"integer indices\" [0 1 9] \"point3 P\" [0 0 0 1 0 0 0 1 0]").is_converted());
    EXPECT_FALSE(area("Shape \"plymesh\" \"string filename\" \"lamp.ply\"").is_converted());
    const FoundLight tube = area("Shape \"cylinder\" \"float radius\" 0.1 \"float zmin\" 0 \"float zmax\" 2");
    EXPECT_EQ(std::get<CylinderShape>(*tube.shape).length.value, 2.0);
    EXPECT_NEAR(number_of(tube), 3000.0, 1e-9); // without caps
    EXPECT_LT(glm::distance(tube.position, glm::dvec3(0.0, 0.0, 1.0)), 1e-14);
    EXPECT_TRUE(scene_of("WorldBegin\nShape \"sphere\"\nAttributeBegin\nAreaLightSource \"diffuse\"\nAttributeEnd\n"
                         "Shape \"sphere\"")
                    .lights.empty());
}

TEST(InterchangePbrt, IncludesAreReadOrMissedByName) {
    SceneReadOptions options;
    options.read_beside = [](const std::string& name) -> Result<std::string> {
        if (name == "lights.pbrt") return std::string("LightSource \"point\"\n");
        if (name == "loop.pbrt") return std::string("Include \"loop.pbrt\"\n");
        return fail(Failure::io, "no such file");
    };
    EXPECT_EQ(
        scene_of("Include \"lights.pbrt\"\nInclude \"lights.pbrt\"\nLightSource \"point\"", options).lights.size(), 3U);
    const FoundScene missing = scene_of("Include \"gone.pbrt\"\n", options);
    ASSERT_EQ(missing.diagnostics.size(), 1U);
    EXPECT_EQ(missing.diagnostics[0].code, "SCN0107");
    const Result<FoundScene> loop = read_scene_lights("Include \"loop.pbrt\"\n", "scene", options);
    ASSERT_FALSE(loop.has_value());
    EXPECT_EQ(loop.error().diagnostics.back().code, "SCN0104");
}

TEST(InterchangePbrt, BrokenFilesFailWithTheirLine) {
    const auto code = [](const std::string& text) { return failure_of(text, "pbrt").code; };
    EXPECT_EQ(code("LightSource \"point"), "SCN0102");
    EXPECT_EQ(code("LightSource point"), "SCN0102");
    EXPECT_EQ(code("LightSource \"point\" \"float scale\""), "SCN0102");
    EXPECT_EQ(code("LightSource \"point\" \"float scale\" [1 2"), "SCN0102");
    EXPECT_EQ(code("Translate 1 2"), "SCN0102");
    EXPECT_EQ(code("Translate 1 2 nan"), "SCN0105");
    EXPECT_EQ(code("AttributeEnd"), "SCN0102");
    EXPECT_EQ(code("\"point\""), "SCN0102");
    std::string deep;
    for (int i = 0; i < 1000; ++i)
        deep += "AttributeBegin\n";
    EXPECT_EQ(code(deep), "SCN0108");
    EXPECT_EQ(failure_of("WorldBegin\n\n  Translate 1 x 2", "pbrt").location.line, 3U);
    EXPECT_FALSE(light_of("LookAt 0 0 0 0 0 0 0 0 1\nLightSource \"point\"").is_converted()); // no direction
}

} // namespace

} // namespace gonio
