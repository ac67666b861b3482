// Sidecars and hashes: real ones checked against the schema in the tree, and what is read back from them.
#include <gonio/asset/content_hash.hpp>
#include <gonio/asset/sidecar.hpp>
#include <gonio/base/file.hpp>

#include "../folders.hpp"
#include "../web/webs.hpp"
#include "json_schema.hpp"

#include <gtest/gtest.h>

namespace gonio {
namespace {

using test::random_web;

test::JsonSchema schema() {
    const std::string path = std::string(test::source_folder) + "/lib/gonio/asset/texture.schema.json";
    return test::JsonSchema(nlohmann::json::parse(read_file(path).value()));
}

const TextureSource source{"lamp \xff.ies", sha256("abc")};

TEST(Sidecar, OfEveryLayoutAndEngineFitsTheSchema) {
    const Web web = random_web(Symmetry::axial, {0}, {0, 90}, 1);
    const test::JsonSchema fits = schema();
    for (const LayoutInfo& layout : layouts()) {
        BakeOptions options;
        options.layout = layout.layout;
        options.width = usual_size(layout.layout).width;
        options.height = usual_size(layout.layout).height;
        const Texture texture = bake_texture(web, options).value();
        TextureFile file;
        if (layout.layout == Layout::cube) file.face_files = {"1", "2", "3", "4", "5", "6"};
        const auto json = nlohmann::json::parse(texture_sidecar(texture, source, file));
        EXPECT_EQ(fits.complaint(json), "") << layout.name;
        EXPECT_EQ(json["width"], layout.layout == Layout::cube ? options.height : options.width);
    }
    for (const Engine& engine : engines()) {
        BakeOptions options = engine.bake;
        while (options.height > 100 && options.sampling == Sampling::mean) {
            options.width /= 4;
            options.height /= 4;
        }
        const Texture texture = bake_texture(web, options).value();
        TextureFile file;
        file.engine = &engine;
        file.channels = engine.channels;
        file.recipe = "all";
        const auto json = nlohmann::json::parse(texture_sidecar(texture, source, file));
        EXPECT_EQ(fits.complaint(json), "") << engine.name;
        EXPECT_EQ(json["frame"]["aim"], engine.aim);
    }
}

// Shows that the schema check can fail.
TEST(Sidecar, SchemaRefusesWhatIsNone) {
    const Texture texture = bake_texture(random_web(Symmetry::axial, {0}, {0, 90}, 1), {}).value();
    const test::JsonSchema fits = schema();
    const auto good = nlohmann::json::parse(texture_sidecar(texture, source, {}));
    ASSERT_EQ(fits.complaint(good), "");
    auto bad = good;
    bad.erase("cd_per_unit");
    EXPECT_EQ(fits.complaint(bad), "$: required cd_per_unit");
    bad = good;
    bad["surplus"] = 1;
    EXPECT_EQ(fits.complaint(bad), "$: additionalProperties surplus");
    bad = good;
    bad["frame"]["aim"] = "down";
    EXPECT_EQ(fits.complaint(bad), "$.frame.aim: enum");
    bad = good;
    bad["width"] = 0;
    EXPECT_EQ(fits.complaint(bad), "$.width: minimum");
    bad = good;
    bad["source"]["sha256"] = "abc";
    EXPECT_EQ(fits.complaint(bad), "$.source.sha256: pattern");
}

TEST(Sidecar, SaysWhatWasClampedAndWhatItWasMadeFrom) {
    const Web web = *Web::create(Symmetry::axial, {0}, {0, 90, 180}, {-5, -5, 100});
    const Texture texture = bake_texture(web, {}).value();
    EXPECT_NEAR(texture.least_mean.value, -5.0, 1e-12);
    TextureFile file;
    file.recipe = "layout=latlong";
    file.files = {file_record("lamp.exr", "bytes")};
    const std::string json = texture_sidecar(texture, source, file);
    EXPECT_NE(json.find("\"clamped_cd\": -"), std::string::npos);
    EXPECT_NE(json.find("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"), std::string::npos);
    EXPECT_EQ(json.back(), '\n');
    const std::optional<TextureRecord> record = read_sidecar(json);
    ASSERT_TRUE(record);
    EXPECT_EQ(record->source_sha256, source.sha256);
    EXPECT_EQ(record->recipe, "layout=latlong");
    EXPECT_EQ(record->files, file.files);
    EXPECT_TRUE(matches(record->files.front(), "bytes"));
    EXPECT_FALSE(matches(record->files.front(), "bytez"));
    EXPECT_FALSE(matches(record->files.front(), "byte"));
    // A name that points outside the folder, and a sidecar that does not describe its picture.
    for (const char* name : {"../lamp.exr", "/lamp.exr", "a/b", "..", ""}) {
        TextureFile other = file;
        other.files = {file_record(name, "bytes")};
        EXPECT_FALSE(read_sidecar(texture_sidecar(texture, source, other))) << name;
    }
    EXPECT_FALSE(read_sidecar(texture_sidecar(texture, source, {})));
    for (const char* none : {"", "{", "[]", "{}", "{\"schema\":\"gonio.texture/1\"}",
                             "{\"schema\":\"gonio.texture/2\"}", "{\"schema\":\"gonio.texture/1\",\"source\":7}"})
        EXPECT_FALSE(read_sidecar(none)) << none;
    bool has_aim = false;
    for (const SidecarField& field : sidecar_fields(json)) {
        has_aim = has_aim || (field.name == "frame.aim" && std::get<std::string>(field.value) == "-Z");
        if (field.name == "peak_cd") {
            EXPECT_EQ(std::get<double>(field.value), 100.0);
        }
    }
    EXPECT_TRUE(has_aim);
}

TEST(ContentHash, AgreesWithTheStandard) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

} // namespace
} // namespace gonio
