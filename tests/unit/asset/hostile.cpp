// Malicious files beside the outputs, and malicious rigs: with unlimited nesting, or with very many lights.
#include <gonio/asset/asset_record.hpp>
#include <gonio/asset/light_scene.hpp>
#include <gonio/asset/manifest.hpp>
#include <gonio/asset/sidecar.hpp>
#include <gonio/asset/target.hpp>
#include <gonio/base/limits.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace gonio {
namespace {

std::string nested(std::size_t levels) {
    return std::string(levels, '[') + std::string(levels, ']');
}

std::string with_extra(std::string json, std::size_t levels) {
    json.insert(1, fmt::format("\"extra\":{},", nested(levels)));
    return json;
}

TEST(HostileJson, DeepSidecarsAreNone) {
    const std::string sidecar =
        R"({"schema":"gonio.texture/1","recipe":"r","source":{"sha256":"s"},"files":[],"cd_per_unit":1})";
    const auto deepest = static_cast<std::size_t>(limit("json-depth").value);
    for (const std::size_t levels : {std::size_t{1}, deepest - 1}) {
        EXPECT_TRUE(read_sidecar(with_extra(sidecar, levels))) << levels;
        EXPECT_FALSE(sidecar_fields(with_extra(sidecar, levels)).empty()) << levels;
    }
    for (const std::size_t levels : {deepest, std::size_t{100000}, std::size_t{5000000}}) {
        EXPECT_FALSE(read_sidecar(with_extra(sidecar, levels))) << levels;
        EXPECT_TRUE(sidecar_fields(with_extra(sidecar, levels)).empty()) << levels;
    }
}

TEST(HostileJson, DeepRecordsAreNone) {
    const std::string record =
        R"({"schema":"gonio.asset/2","source":{"sha256":"s"},"files":[],"instead":[],"target":"gltf"})";
    EXPECT_TRUE(read_asset_record(with_extra(record, limit("json-depth").value - 1)));
    EXPECT_FALSE(read_asset_record(with_extra(record, 100000)));
}

TEST(HostileJson, DeepManifestsAreRefusedWithTheirPlace) {
    const auto refusal = [](const std::string& text) {
        const Result<Manifest> manifest = read_manifest(text, "m.json");
        return manifest ? std::string("read") : to_text(manifest.error().diagnostics.back());
    };
    EXPECT_EQ(refusal("{\"schema\":\"gonio.manifest/1\",\n\"extra\":" + nested(100000) + "}"),
              "m.json:2:72: error[INP0101]: nested deeper than 64 levels, the limit 'json-depth'\n"
              "hint: 'gonio list limits' describes each limit");
    EXPECT_EQ(refusal("\n  [3]"), "m.json:2:3: error[INP0101]: not a manifest: it is not a JSON object");
    EXPECT_EQ(refusal("root:x:0:0"), "m.json:1:1: error[INP0101]: broken JSON: invalid literal");
    EXPECT_EQ(refusal(R"({"schema":"hunter2"})"), "m.json: error[UNS0101]: the schema is not gonio.manifest/1");
}

std::vector<Light> suns(std::size_t count) {
    LightDescription description;
    description.name = "lamp";
    description.shape = *parse_shape("sun:angle=1deg");
    description.intensity = *parse_photometric_value("1lx");
    Diagnostics ignored;
    return std::vector<Light>(count, *resolve_light(description, ignored));
}

// If each equal name searched for a free number from the start, the n-th would take n steps: an hour at 100 000.
TEST(ManyLights, OfOneNameAreNumberedInTurn) {
    const Result<LightScene> scene = light_scene(**find_target("gltf"), suns(20000), {"rig", "", Meters(1.0)});
    ASSERT_TRUE(scene);
    for (const char* name : {"\"lamp\"", "\"lamp_2\"", "\"lamp_20000\""})
        EXPECT_NE(scene->files[0].bytes.find(name), std::string::npos) << name;
    EXPECT_EQ(scene->files[0].bytes.find("\"lamp_20001\""), std::string::npos);
}

TEST(ManyLights, BeyondTheLimitAreRefused) {
    const Result<LightScene> scene =
        light_scene(**find_target("gltf"), suns(limit("import-lights").value + 1), {"rig", "", Meters(1.0)});
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().failure, Failure::unsupported);
    EXPECT_EQ(
        scene.error().diagnostics.back().message,
        fmt::format("{} lights are more than {}", limit("import-lights").value + 1, to_text(limit("import-lights"))));
}

} // namespace
} // namespace gonio
