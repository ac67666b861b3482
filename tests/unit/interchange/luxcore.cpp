// Lights of LuxCore: values that follow from its documents, and broken files.
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

TEST(InterchangeLuxCore, PowerTimesEfficacyIsTheFlux) {
    const FoundScene scene = scene_of("# a scene\nscene.lights.key.type = \"point\"\nscene.lights.key.power = 60\n"
                                      "scene.lights.key.efficency = 17\nscene.lights.key.position = 1 2 3\n"
                                      "scene.lights.raw.type = \"point\"\nscene.lights.raw.gain = 5 5 5\n"
                                      "scene.lights.ball.type = \"sphere\"\nscene.lights.ball.power = 1\n"
                                      "scene.lights.ball.efficency = 1\nscene.lights.ball.radius = 0.2\n");
    ASSERT_EQ(scene.lights.size(), 3U);
    EXPECT_EQ(scene.lights[0].name, "key");
    EXPECT_EQ(number_of(scene.lights[0]), 1020.0);
    EXPECT_EQ(unit_of(scene.lights[0]), "lm");
    EXPECT_EQ(scene.lights[0].position, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_FALSE(scene.lights[1].is_converted());
    EXPECT_EQ(std::get<SphereShape>(*scene.lights[2].shape).radius.value, 0.2);
}

TEST(InterchangeLuxCore, MaterialsGlow) {
    const std::string mesh =
        "scene.shapes.s.type = \"inlinedmesh\"\nscene.shapes.s.vertices = 0 0 1 2 0 1 2 1 1 0 1 1\n"
        "scene.shapes.s.faces = 0 1 2 0 2 3\nscene.objects.o.shape = \"s\"\nscene.objects.o.material = \"m\"\n"
        "scene.materials.m.type = \"matte\"\nscene.materials.m.emission = 1 1 1\n"
        "scene.materials.m.emission.gain = 700 700 700\n";
    const FoundScene scene = scene_of(mesh);
    ASSERT_EQ(scene.lights.size(), 1U);
    const auto& rect = std::get<RectShape>(*scene.lights[0].shape);
    EXPECT_NEAR(rect.width.value, 2.0, 1e-15);
    EXPECT_NEAR(rect.height.value, 1.0, 1e-15);
    EXPECT_EQ(number_of(scene.lights[0]), 700.0);
    EXPECT_TRUE(has_remark(scene.lights[0], "SCN0201"));
    EXPECT_LT(glm::distance(scene.lights[0].direction, glm::dvec3(0.0, 0.0, 1.0)), 1e-15);
}

TEST(InterchangeLuxCore, BrokenFilesFailWithTheirLine) {
    const auto code = [](const std::string& text) { return failure_of(text, "luxcore").code; };
    EXPECT_EQ(code("scene.lights.a.type"), "SCN0102");
    EXPECT_EQ(code("scene.lights.a.type = \"point\"\nscene.lights.a.power = x"), "SCN0105");
    EXPECT_EQ(code("scene.lights.a.type = \"point\"\nscene.lights.a.color = 1 2"), "SCN0105");
    EXPECT_EQ(
        code("scene.objects.o.shape = \"gone\"\nscene.objects.o.material = \"m\"\nscene.materials.m.emission = 1 1 1"),
        "SCN0103");
    EXPECT_EQ(failure_of("scene.a.b.c = 1\n\nhello", "luxcore").location.line, 3U);
}

} // namespace

} // namespace gonio
