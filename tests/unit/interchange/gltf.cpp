// Lights of glTF: values that follow from the extensions' documents, and hostile files.
#include <gonio/interchange/audit.hpp>
#include <gonio/light/light_color.hpp>

#include "scenes.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <string>

namespace gonio {

namespace {

using test::failure_of;
using test::has_remark;
using test::number_of;
using test::scene_of;
using test::unit_of;

std::string gltf(const std::string& lights, const std::string& nodes, const std::string& more = {}) {
    return R"({"asset":{"version":"2.0"},"extensions":{"KHR_lights_punctual":{"lights":[)" + lights +
           R"(]}},"nodes":[)" + nodes + "]" + more + "}";
}

std::string node(int light, const std::string& more = {}) {
    return fmt::format(R"({{"extensions":{{"KHR_lights_punctual":{{"light":{}}}}}{}}})", light, more);
}

void append_u32(std::string& bytes, std::size_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>((value >> shift) & 0xffU);
}

std::string glb(std::string json, std::string binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    std::string bytes = "glTF";
    append_u32(bytes, 2);
    append_u32(bytes, 12 + 8 + json.size() + 8 + binary.size());
    append_u32(bytes, json.size());
    bytes += "JSON" + json;
    append_u32(bytes, binary.size());
    return bytes + std::string("BIN\0", 4) + binary;
}

TEST(InterchangeGltf, DefaultsAreThoseOfTheExtension) {
    const FoundScene scene = scene_of(gltf(R"({"type":"point"},{"type":"spot","spot":{}},{"type":"directional"})",
                                           node(0) + "," + node(1) + "," + node(2)));
    ASSERT_EQ(scene.lights.size(), 3U);
    EXPECT_EQ(number_of(scene.lights[0]), 1.0);
    EXPECT_EQ(unit_of(scene.lights[0]), "cd");
    const auto& spot = std::get<SpotShape>(*scene.lights[1].shape);
    EXPECT_DOUBLE_EQ(spot.outer.value, std::numbers::pi / 4.0);
    EXPECT_EQ(spot.inner.value, 0.0);
    EXPECT_EQ(spot.falloff, Falloff::frostbite);
    EXPECT_EQ(unit_of(scene.lights[2]), "lx");
    EXPECT_TRUE(has_remark(scene.lights[2], "SCN0201"));
    // −Z of glTF, whose up is +Y, is horizontal: +Y of gonio.
    EXPECT_EQ(scene.lights[0].direction, glm::dvec3(0.0, 1.0, 0.0));
    EXPECT_EQ(scene.lights[0].up, glm::dvec3(0.0, 0.0, 1.0));
}

TEST(InterchangeGltf, TheColourMultipliesTheAmount) {
    const FoundScene scene = scene_of(gltf(R"({"type":"point","intensity":1000,"color":[0,0,1]})", node(0)));
    EXPECT_NEAR(number_of(scene.lights[0]), 1000.0 * rec709_luminance.z, 1e-9); // 72 cd
    EXPECT_NEAR(scene.lights[0].color.z, 1.0 / rec709_luminance.z, 1e-12);
    EXPECT_TRUE(has_remark(scene_of(gltf(R"({"type":"point","color":[1,1,-0.1]})", node(0))).lights[0], "SCN0202"));
}

TEST(InterchangeGltf, NodesPlaceLightsAndScaleMovesThemOnly) {
    // A parent at x = 10 with a scale of 2, a child one unit up, turned by 90° about X: −Z becomes +Y, up.
    const std::string half = "0.70710678118654757";
    const FoundScene scene = scene_of(
        gltf(R"({"type":"point","intensity":5})",
             R"({"translation":[10,0,0],"scale":[2,2,2],"children":[1]},)" +
                 node(0, R"(,"name":"lamp","translation":[0,1,0],"rotation":[)" + half + ",0,0," + half + "]")));
    ASSERT_EQ(scene.lights.size(), 1U);
    const FoundLight& light = scene.lights[0];
    EXPECT_EQ(light.name, "lamp");
    EXPECT_EQ(light.place, "nodes[1]");
    EXPECT_NEAR(glm::distance(light.position, glm::dvec3(10.0, 0.0, 2.0)), 0.0, 1e-14);
    EXPECT_NEAR(glm::distance(light.direction, glm::dvec3(0.0, 0.0, 1.0)), 0.0, 1e-14);
    EXPECT_EQ(number_of(light), 5.0);
    SceneReadOptions centimeters;
    centimeters.unit = Meters(0.01);
    EXPECT_NEAR(
        scene_of(gltf(R"({"type":"point"})", node(0, R"(,"translation":[100,0,0])")), centimeters).lights[0].position.x,
        1.0, 1e-15);
}

TEST(InterchangeGltf, OnlyTheShownSceneCounts) {
    const std::string text =
        gltf(R"({"type":"point"})", node(0) + "," + node(0), R"(,"scene":1,"scenes":[{"nodes":[0]},{"nodes":[1]}])");
    const FoundScene scene = scene_of(text);
    ASSERT_EQ(scene.lights.size(), 2U);
    EXPECT_FALSE(scene.lights[0].is_converted());
    EXPECT_TRUE(has_remark(scene.lights[0], "SCN0204"));
    EXPECT_TRUE(scene.lights[1].is_converted());
}

TEST(InterchangeGltf, AreaLightsOfTheProposal) {
    const std::string text =
        R"({"asset":{"version":"2.0"},"extensions":{"EXT_lights_area":{"lights":[
            {"type":"rect","intensity":3000,"size":0.5,"rect":{"aspect":2}},{"type":"disk","size":0.4}]}},
            "nodes":[{"scale":[2,1,1],"extensions":{"EXT_lights_area":{"light":0}}},
                     {"extensions":{"EXT_lights_area":{"light":1}}}]})";
    const FoundScene scene = scene_of(text);
    const auto& rect = std::get<RectShape>(*scene.lights[0].shape);
    EXPECT_DOUBLE_EQ(rect.width.value, 2.0);
    EXPECT_DOUBLE_EQ(rect.height.value, 1.0);
    EXPECT_FALSE(rect.two_sided);
    EXPECT_EQ(number_of(scene.lights[0]), 3000.0);
    EXPECT_EQ(unit_of(scene.lights[0]), "nt");
    EXPECT_DOUBLE_EQ(std::get<DiskShape>(*scene.lights[1].shape).radius.value, 0.2);
    EXPECT_EQ(number_of(scene.lights[1]), 1000.0);
}

TEST(InterchangeGltf, GlowingMeshesAreListed) {
    const std::string text =
        R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0,"name":"panel"}],
            "meshes":[{"primitives":[{"material":1,"attributes":{"POSITION":0}},{"material":0}]}],"accessors":[{}],
            "materials":[{"emissiveFactor":[0,0,0]},{"emissiveFactor":[1,0.5,0.25],
              "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":4}}}]})";
    const FoundScene scene = scene_of(text);
    ASSERT_EQ(scene.lights.size(), 1U);
    EXPECT_EQ(scene.lights[0].kind, "mesh");
    EXPECT_EQ(scene.lights[0].stated, "emission 4 2 1");
    EXPECT_TRUE(has_remark(scene.lights[0], "SCN0203"));
}

TEST(InterchangeGltf, HostileFilesFailWithCodeAndPlace) {
    const auto code = [](const std::string& text) { return failure_of(text).code; };
    const std::string point = R"({"type":"point"})";
    EXPECT_EQ(code(gltf(point, node(1))), "SCN0103");
    EXPECT_EQ(code(gltf(point, R"({"children":[7]})")), "SCN0103");
    EXPECT_EQ(code(gltf(point, R"({"children":[1]},{"children":[0]})")), "SCN0104");
    EXPECT_EQ(code(gltf(point, R"({"children":[0]})")), "SCN0104");
    EXPECT_EQ(code(gltf(point, R"({"children":[2]},{"children":[2]},)" + node(0))), "SCN0104");
    EXPECT_EQ(code(gltf(point, node(0, R"(,"translation":[1,2])"))), "SCN0105");
    EXPECT_EQ(code(gltf(point, node(0, R"(,"translation":[1,2,"x"])"))), "SCN0105");
    EXPECT_EQ(code(gltf(point, node(0, R"(,"rotation":[0,0,0,0])"))), "SCN0105");
    EXPECT_EQ(code(gltf(point, node(0, R"(,"translation":[NaN,0,0])"))), "SCN0102");
    EXPECT_EQ(code(gltf(point, node(0, R"(,"translation":[1e999,0,0])"))), "SCN0102");
    EXPECT_EQ(code(gltf(R"({"type":"point","intensity":"1"})", node(0))), "SCN0105");
    EXPECT_EQ(code(gltf(point, node(0), R"(,"extensionsRequired":["ACME_lights"])")), "SCN0106");
    EXPECT_EQ(code(gltf(point, node(0), R"(,"scenes":[{"nodes":[9]}])")), "SCN0103");
    EXPECT_EQ(code(gltf(point, node(0), R"(,"nodes":[])")), "SCN0102");
    EXPECT_EQ(code(R"({"asset":{"version":"1.0"},"nodes":[]})"), "SCN0101");
    EXPECT_EQ(code(R"({"asset":{},"nodes":[]})"), "SCN0102");
    EXPECT_EQ(code(R"({"asset":{"version":"2.0"},"nodes":{}})"), "SCN0105");
    EXPECT_EQ(code(R"({"asset":{"version":"2.0"},"nodes":[[]]})"), "SCN0105");
    EXPECT_EQ(code(R"({"asset":{"version":"2.0"},"nodes":[1]})"), "SCN0105");
    EXPECT_EQ(code(R"({"asset":{"version":"2.0"},"nodes":[)"), "SCN0102");
    EXPECT_EQ(code(R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"material":0,
        "attributes":{"POSITION":3}}]}],"materials":[{"emissiveFactor":[1,1,1]}],"accessors":[]})"),
              "SCN0103");
    EXPECT_EQ(code("hello"), "SCN0101");
    EXPECT_EQ(code("PXR-USDC\0\0"), "SCN0101");
    const Diagnostic said = failure_of(gltf(point, "\n" + node(3)));
    EXPECT_EQ(said.location.line, 2U);
    EXPECT_EQ(said.message, "nodes[0]: KHR_lights_punctual: there is no light 3, only 1");
}

TEST(InterchangeGltf, LightsWithImpossibleValuesAreListedOnly) {
    const auto only_listed = [](const std::string& light, const std::string& more = {}) {
        const FoundScene scene = scene_of(gltf(light, node(0, more)));
        return !scene.lights[0].is_converted() && has_remark(scene.lights[0], "SCN0203");
    };
    EXPECT_TRUE(only_listed(R"({"type":"spot","spot":{"outerConeAngle":45}})"));
    EXPECT_TRUE(only_listed(R"({"type":"spot","spot":{"outerConeAngle":0.5,"innerConeAngle":0.6}})"));
    EXPECT_TRUE(only_listed(R"({"type":"point","intensity":-5})"));
    EXPECT_TRUE(only_listed(R"({"type":"laser"})"));
    EXPECT_TRUE(only_listed(R"({"type":"point"})", R"(,"scale":[1,1,0])"));
    EXPECT_TRUE(only_listed(R"({"type":"point"})", R"(,"scale":[1e300,1e300,1e300],"translation":[1e300,1,1])"));
    EXPECT_TRUE(
        only_listed(R"({"type":"point"})", R"(,"matrix":[1e308,0,0,0,0,1e308,0,0,0,0,1e308,0,1e308,1e308,1e308,1])"));
}

TEST(InterchangeGltf, TruncatedGlbsFailAtEveryByte) {
    const std::string whole = glb(gltf(R"({"type":"point"})", node(0)), "0123");
    EXPECT_EQ(scene_of(whole).lights.size(), 1U);
    for (std::size_t length = 4; length < whole.size(); ++length)
        EXPECT_EQ(failure_of(whole.substr(0, length)).code, "SCN0102") << length;
}

TEST(InterchangeGltf, ProfilesInBuffersAreKeptOrMissedByName) {
    const auto with_view = [](const std::string& view, const std::string& buffer) {
        return R"({"asset":{"version":"2.0"},"extensions":{"EXT_lights_ies":{"lights":[{"bufferView":0,"name":"a b"}]}},
            "buffers":[)" +
               buffer + R"(],"bufferViews":[)" + view + R"(],
            "nodes":[{"extensions":{"EXT_lights_ies":{"light":0,"multiplier":2}}},{"extensions":{"EXT_lights_ies":{"light":0}}}]})";
    };
    const std::string buffer = R"({"byteLength":4})";
    const FoundScene scene = scene_of(glb(with_view(R"({"buffer":0,"byteLength":4})", buffer), "IESN"));
    ASSERT_EQ(scene.profiles.size(), 1U);
    EXPECT_EQ(scene.profiles[0].name, "a_b");
    EXPECT_EQ(scene.profiles[0].bytes, "IESN");
    EXPECT_EQ(scene.lights[0].profile, 0U);
    EXPECT_EQ(scene.lights[1].profile, 0U);
    EXPECT_EQ(scene.lights[0].profile_scale, 2.0);
    EXPECT_EQ(failure_of(glb(with_view(R"({"buffer":0,"byteOffset":2,"byteLength":4})", buffer), "IESN")).code,
              "SCN0103");
    EXPECT_EQ(failure_of(glb(with_view(R"({"buffer":1,"byteLength":4})", buffer), "IESN")).code, "SCN0103");
    EXPECT_EQ(failure_of(glb(with_view("", buffer), "IESN")).code, "SCN0103");
    EXPECT_EQ(failure_of(glb(with_view(R"({"buffer":0,"byteLength":18446744073709551615})", buffer), "IESN")).code,
              "SCN0103");
    const FoundScene missing =
        scene_of(with_view(R"({"buffer":0,"byteLength":4})", R"({"byteLength":4,"uri":"gone.bin"})"));
    EXPECT_TRUE(has_remark(missing.lights[0], "SCN0107"));
    FoundScene broken = scene_of(with_view(
        R"({"buffer":0,"byteLength":4})", R"({"byteLength":4,"uri":"data:application/octet-stream;base64,SUVTTg=="})"));
    EXPECT_EQ(broken.profiles[0].bytes, "IESN");
    load_scene_profiles(broken, {});
    EXPECT_FALSE(broken.lights[0].is_converted());
    EXPECT_TRUE(has_remark(broken.lights[0], "SCN0107"));
}

std::vector<std::string> audit_codes(const std::string& text, std::optional<double> lumens_per_watt = {}) {
    std::vector<std::string> codes;
    for (const SceneFinding& finding : audit_scene(scene_of(text), lumens_per_watt))
        codes.emplace_back(finding.code->code);
    return codes;
}

using Codes = std::vector<std::string>;

TEST(InterchangeAudit, FindsWhatIsImplausible) {
    const auto of_light = [](const std::string& light) { return audit_codes(gltf(light, node(0))); };
    EXPECT_EQ(of_light(R"({"type":"point","intensity":64})"), Codes{});
    EXPECT_EQ(of_light(R"({"type":"point","intensity":5435.141})"), Codes{"SCN0301"}); // 100 W × 683 / 4π
    EXPECT_EQ(of_light(R"({"type":"directional","intensity":683000})"), (Codes{"SCN0301", "SCN0302"}));
    EXPECT_EQ(of_light(R"({"type":"point","intensity":159155})"), Codes{"SCN0302"}); // 2,000,000 lm
    EXPECT_EQ(of_light(R"({"type":"point","intensity":-4})"), Codes{"SCN0309"});
    EXPECT_EQ(of_light(R"({"type":"point","intensity":0})"), Codes{"SCN0310"});
    EXPECT_EQ(of_light(R"({"type":"point","color":[0,0,0],"intensity":50})"), Codes{"SCN0310"});
    EXPECT_EQ(of_light(R"({"type":"point","color":[2,1,1],"intensity":50})"), Codes{"SCN0312"});
    EXPECT_EQ(of_light(R"({"type":"spot","intensity":50,"spot":{"outerConeAngle":45}})"), Codes{"SCN0304"});
    EXPECT_EQ(of_light(R"({"type":"spot","intensity":50,"spot":{"outerConeAngle":2}})"), Codes{"SCN0304"});
    const std::string two = R"({"type":"point","intensity":100},{"type":"point","intensity":1256.637061})";
    EXPECT_EQ(audit_codes(gltf(two, node(0) + "," + node(1))), Codes{"SCN0303"});
    EXPECT_EQ(
        audit_codes(gltf(R"({"type":"point","intensity":64})", node(0) + "," + node(0, R"(,"translation":[400,0,0])"))),
        Codes{"SCN0305"});
    EXPECT_EQ(
        audit_codes(gltf(R"({"type":"point","intensity":2})", node(0) + "," + node(0, R"(,"translation":[4,0,0])"))),
        Codes{"SCN0311"});
    EXPECT_TRUE(has_remark(scene_of(gltf(R"({"type":"point","range":0})", node(0))).lights[0], "SCN0308"));
}

TEST(InterchangeAudit, FixesChangeOnlyTheirNumbers) {
    const std::string text =
        gltf(R"({"type" : "spot" , "intensity" : 5435.141, "spot":{"innerConeAngle":0.8,"outerConeAngle": 2.0 }},
                {"type":"point","intensity":-4},{"type":"point","color":[0.5,0.25,0],"intensity":50})",
             node(0) + "," + node(1) + "," + node(2), R"(,"extras":{"intensity":7})");
    const auto fixed_text = [](const std::string& of) {
        const FoundScene scene = scene_of(of);
        const Result<FixedScene> fixed = fix_scene(of, scene, audit_scene(scene, 100.0));
        EXPECT_TRUE(fixed.has_value());
        return *fixed;
    };
    const FixedScene fixed = fixed_text(text);
    std::string expected = text;
    const auto replace = [&](const std::string& from, const std::string& to) {
        expected.replace(expected.find(from), from.size(), to);
    };
    replace(": 2.0 ", ": 1 ");
    replace(":0.8,", ":0.4,");
    replace(":-4}", ":4}");
    replace("[0.5,0.25,0],\"intensity\":50", "[1,0.5,0],\"intensity\":25");
    EXPECT_EQ(fixed.bytes, expected);
    ASSERT_EQ(fixed.applied.size(), 7U);
    EXPECT_EQ(fixed.applied[0].path, "spot.innerConeAngle");
    EXPECT_EQ(fixed.applied[0].code, "SCN0304");
    // The cone was impossible, so that the watts are seen only now.
    const FixedScene again = fixed_text(fixed.bytes);
    ASSERT_EQ(again.applied.size(), 1U);
    EXPECT_EQ(again.applied[0].code, "SCN0301");
    EXPECT_NEAR(again.applied[0].to, 100.0 * 100.0 / (4.0 * std::numbers::pi), 1e-3);
    const FixedScene binary = fixed_text(glb(text, "01234567"));
    EXPECT_EQ(binary.applied.size(), 7U);
    EXPECT_TRUE(binary.bytes.ends_with("01234567"));
    EXPECT_EQ(number_of(scene_of(binary.bytes).lights[1]), 4.0);
}

} // namespace

} // namespace gonio
