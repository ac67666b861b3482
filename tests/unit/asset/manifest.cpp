// Manifests: written, read, merged, and checked against the schema in the tree.
#include <gonio/asset/asset_record.hpp>
#include <gonio/asset/content_hash.hpp>
#include <gonio/asset/manifest.hpp>
#include <gonio/base/file.hpp>

#include "../folders.hpp"
#include "json_schema.hpp"

#include <gtest/gtest.h>

namespace gonio {
namespace {

Manifest part(std::size_t index, std::size_t count, const std::vector<std::string>& inputs) {
    Manifest manifest;
    manifest.recipe = "layout=latlong";
    manifest.shard = Shard{index, count};
    manifest.inputs = inputs.size();
    for (const std::string& input : inputs)
        manifest.assets.push_back({{input, sha256(input)}, {{input + ".exr", sha256("exr")}}});
    return manifest;
}

std::string refusal(const std::vector<Manifest>& manifests) {
    const Result<Manifest> whole = merged(manifests);
    return whole ? "merged" : whole.error().diagnostics.front().message;
}

TEST(Manifest, ReadsWhatItWrites) {
    Manifest manifest = part(2, 3, {"a.ies", "b.ies"});
    manifest.failed = {"c.ies"};
    manifest.inputs = 3;
    EXPECT_EQ(read_manifest(manifest_json(manifest), "m.json").value(), manifest);
    manifest.shard.reset();
    EXPECT_EQ(read_manifest(manifest_json(manifest), "m.json").value(), manifest);
    const std::string path = std::string(test::source_folder) + "/lib/gonio/asset/manifest.schema.json";
    const test::JsonSchema schema(nlohmann::json::parse(read_file(path).value()));
    for (const Manifest& of : {manifest, part(1, 2, {"x"}), Manifest()})
        EXPECT_EQ(schema.complaint(nlohmann::json::parse(manifest_json(of))), "");
    auto bad = nlohmann::json::parse(manifest_json(manifest));
    bad["assets"][0]["files"][0].erase("sha256");
    EXPECT_EQ(schema.complaint(bad), "$.assets[].files[]: required sha256");
}

TEST(Manifest, RefusesWhatIsNone) {
    for (const char* text :
         {"", "[]", "{", "{}", "{\"schema\":\"gonio.manifest/1\"}",
          "{\"schema\":\"gonio.manifest/1\",\"recipe\":1,\"inputs\":0,\"assets\":[],\"failed\":[]}",
          "{\"schema\":\"gonio.manifest/1\",\"recipe\":\"\",\"inputs\":-1,\"assets\":[],\"failed\":[]}",
          "{\"schema\":\"gonio.manifest/1\",\"recipe\":\"\",\"inputs\":0,\"assets\":{},\"failed\":[]}",
          "{\"schema\":\"gonio.manifest/1\",\"recipe\":\"\",\"inputs\":0,\"assets\":[3],\"failed\":[]}",
          "{\"schema\":\"gonio.manifest/1\",\"recipe\":\"\",\"inputs\":0,\"shard\":2,\"assets\":[],"
          "\"failed\":[]}"}) {
        const Result<Manifest> manifest = read_manifest(text, "m.json");
        ASSERT_FALSE(manifest) << text;
        EXPECT_EQ(manifest.error().failure, Failure::malformed) << text;
        EXPECT_EQ(manifest.error().diagnostics.front().location.file, "m.json");
    }
    EXPECT_EQ(read_manifest("{\"schema\":\"gonio.manifest/2\"}", "m").error().failure, Failure::unsupported);
}

TEST(Manifest, RefusesAShardThatDoesNotExist) {
    for (const Manifest& odd : {part(0, 3, {}), part(4, 3, {}), part(1, 0, {})}) {
        const Result<Manifest> manifest = read_manifest(manifest_json(odd), "m.json");
        ASSERT_FALSE(manifest);
        EXPECT_EQ(manifest.error().failure, Failure::malformed);
    }
}

TEST(Manifest, MergesShardsInAnyOrder) {
    Manifest second = part(2, 3, {"b.ies", "e.ies"});
    second.failed = {"h.ies"};
    second.inputs = 3;
    const std::vector<Manifest> parts{part(3, 3, {"c.ies"}), part(1, 3, {"a.ies", "d.ies"}), second};
    const Manifest whole = merged(parts).value();
    EXPECT_FALSE(whole.shard);
    EXPECT_EQ(whole.inputs, 6U);
    ASSERT_EQ(whole.assets.size(), 5U);
    EXPECT_EQ(whole.assets.front().input.file, "a.ies");
    EXPECT_EQ(whole.assets.back().input.file, "e.ies");
    EXPECT_EQ(whole.failed, std::vector<std::string>{"h.ies"});
}

TEST(Manifest, RefusesShardsThatMakeNoWhole) {
    EXPECT_EQ(refusal({}), "there is no manifest to merge");
    EXPECT_EQ(refusal({part(1, 3, {"a"}), part(3, 3, {"c"})}), "the manifest of shard 2/3 is missing");
    EXPECT_EQ(refusal({part(1, 2, {"a"}), part(1, 2, {"b"})}), "shard 1/2 is given twice");
    EXPECT_EQ(refusal({part(1, 2, {"a"}), part(2, 3, {"b"})}), "the manifests have different numbers of shards");
    EXPECT_EQ(refusal({part(1, 2, {"a"}), part(2, 2, {"a"})}), "two manifests list the input 'a'");
    Manifest other = part(2, 2, {"b"});
    other.recipe = "layout=v180";
    EXPECT_EQ(refusal({part(1, 2, {"a"}), other}), "the manifests were made with different options");
    Manifest same_file = part(2, 2, {"b"});
    same_file.assets.front().files.front().file = "a.exr";
    EXPECT_EQ(refusal({part(1, 2, {"a"}), same_file}), "two inputs were written to 'a.exr'");
}

TEST(Manifest, KeepsRemarks) {
    Manifest manifest = part(1, 1, {"a.json"});
    manifest.assets[0].remarks = {"gltf: light 'tube': gltf has no tube lights"};
    const std::string json = manifest_json(manifest);
    EXPECT_EQ(*read_manifest(json, "m.json"), manifest);
    const test::JsonSchema schema(
        nlohmann::json::parse(*read_file(std::string(test::source_folder) + "/lib/gonio/asset/manifest.schema.json")));
    EXPECT_EQ(schema.complaint(nlohmann::json::parse(json)), "");
}

TEST(AssetRecord, IsReadAsWritten) {
    AssetRecord record;
    record.target = "gltf";
    record.recipe = "gonio import";
    record.source_file = "studio.json";
    record.source_sha256 = sha256("studio");
    record.files = {file_record("studio.gltf", "{}"), file_record("studio.glb", "glTF")};
    record.instead = {"light 'tube': gltf has no tube lights"};
    const std::string text = asset_record_json(record);
    const auto again = read_asset_record(text);
    ASSERT_TRUE(again);
    EXPECT_EQ(asset_record_json(*again), text);
    const test::JsonSchema schema(
        nlohmann::json::parse(*read_file(std::string(test::source_folder) + "/lib/gonio/asset/asset.schema.json")));
    EXPECT_EQ(schema.complaint(nlohmann::json::parse(text)), "");
    for (const char* bad : {"", "[]", "{}", R"({"schema": "gonio.asset/2", "files": [1], "instead": []})",
                            R"({"schema": "gonio.asset/1", "files": [], "instead": [], "source": {"sha256": "1"}})"})
        EXPECT_FALSE(read_asset_record(bad)) << bad;
    // Names that point outside the folder are not followed.
    for (const char* name : {"../studio.gltf", "/etc/passwd", "a/b", ".", ""}) {
        record.files = {file_record(name, "{}")};
        EXPECT_FALSE(read_asset_record(asset_record_json(record))) << name;
    }
}

} // namespace
} // namespace gonio
