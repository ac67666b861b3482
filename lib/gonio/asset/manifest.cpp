#include <gonio/asset/manifest.hpp>
#include <gonio/base/json_text.hpp>
#include <gonio/base/version.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>

namespace gonio {

namespace {

using detail::Json;

Json to_json(const ManifestFile& file) {
    return {{"file", file.file}, {"sha256", file.sha256}};
}

// Reads members and remembers the first one that is missing or has the wrong type.
class Reader {
public:
    explicit Reader(const std::string& name) : name_(name) {}

    const Json& member(const Json& object, const char* key, bool (Json::*is_right)() const noexcept) {
        static const Json nothing;
        const Json* const found = object.find(key);
        if (found != nullptr && (found->*is_right)()) return *found;
        if (wrong_.empty()) wrong_ = key;
        return nothing;
    }
    std::string text(const Json& object, const char* key) {
        const Json& value = member(object, key, &Json::is_string);
        return value.is_string() ? value.as_string() : std::string();
    }
    std::size_t count(const Json& object, const char* key) {
        const Json& value = member(object, key, &Json::is_unsigned);
        constexpr std::uint64_t most = std::numeric_limits<std::size_t>::max();
        return value.is_unsigned() ? static_cast<std::size_t>(std::min(value.as_uint64(), most)) : 0;
    }
    ManifestFile file(const Json& object) { return {text(object, "file"), text(object, "sha256")}; }

    // The error to return, if there is one.
    [[nodiscard]] std::optional<Unexpected> failure() const {
        if (wrong_.empty()) return std::nullopt;
        return fail(Failure::malformed, fmt::format("not a manifest: '{}' is missing or has the wrong type", wrong_),
                    {}, name_);
    }

private:
    const std::string& name_;
    std::string wrong_;
};

} // namespace

void sort_by_name(Manifest& manifest) {
    std::sort(manifest.assets.begin(), manifest.assets.end(),
              [](const ManifestAsset& a, const ManifestAsset& b) { return a.input.file < b.input.file; });
    std::sort(manifest.failed.begin(), manifest.failed.end());
}

std::string manifest_json(const Manifest& manifest) {
    Json json{{"schema", "gonio.manifest/1"}, {"tool", std::string("gonio ") + version},
              {"recipe", manifest.recipe},    {"shard", nullptr},
              {"inputs", manifest.inputs},    {"assets", Json::array()},
              {"failed", manifest.failed}};
    if (manifest.shard) json["shard"] = {{"index", manifest.shard->index}, {"count", manifest.shard->count}};
    for (const ManifestAsset& asset : manifest.assets) {
        Json files = Json::array();
        for (const ManifestFile& file : asset.files)
            files.push_back(to_json(file));
        json["assets"].push_back({{"input", to_json(asset.input)}, {"files", std::move(files)}});
        if (!asset.remarks.empty()) json["assets"].back()["remarks"] = asset.remarks;
    }
    return json.dump(2) + "\n";
}

Result<Manifest> read_manifest(std::string_view text, const std::string& name) {
    const Result<Json> parsed = detail::parse_json(text, name);
    if (!parsed) return Unexpected(parsed.error());
    const Json& json = *parsed;
    if (!json.is_object()) {
        Error error = fail(Failure::malformed, "not a manifest: it is not a JSON object", {}, name).value();
        error.diagnostics.back().location = detail::location_in(text, text.find_first_not_of(" \t\r\n"), name);
        return Unexpected(std::move(error));
    }
    Reader reader(name);
    const std::string schema = reader.text(json, "schema");
    if (!schema.empty() && schema != "gonio.manifest/1")
        return fail(Failure::unsupported,
                    schema.starts_with("gonio.") ? fmt::format("the schema is '{}', not gonio.manifest/1", schema)
                                                 : "the schema is not gonio.manifest/1",
                    {}, name);
    Manifest manifest;
    manifest.recipe = reader.text(json, "recipe");
    manifest.inputs = reader.count(json, "inputs");
    if (const Json* const shard = json.find("shard"); shard != nullptr && !shard->is_null())
        manifest.shard = Shard{reader.count(*shard, "index"), reader.count(*shard, "count")};
    for (const Json& asset : reader.member(json, "assets", &Json::is_array)) {
        ManifestAsset read;
        read.input = reader.file(reader.member(asset, "input", &Json::is_object));
        for (const Json& file : reader.member(asset, "files", &Json::is_array))
            read.files.push_back(reader.file(file));
        if (asset.contains("remarks"))
            for (const Json& remark : reader.member(asset, "remarks", &Json::is_array))
                if (remark.is_string()) read.remarks.push_back(remark.as_string());
        manifest.assets.push_back(std::move(read));
    }
    for (const Json& input : reader.member(json, "failed", &Json::is_array))
        if (input.is_string()) manifest.failed.push_back(input.as_string());
    if (auto failure = reader.failure()) return *failure;
    if (manifest.shard && (manifest.shard->index < 1 || manifest.shard->index > manifest.shard->count))
        return fail(
            Failure::malformed,
            fmt::format("not a manifest: there is no shard {}/{}", manifest.shard->index, manifest.shard->count),
            "shards are counted from 1", name);
    return manifest;
}

Result<Manifest> merged(std::span<const Manifest> manifests) {
    if (manifests.empty()) return fail("USE0104", "there is no manifest to merge");
    Manifest whole;
    whole.recipe = manifests.front().recipe;
    std::set<std::size_t> shards;
    std::set<std::string> inputs;
    std::set<std::string> files;
    const std::size_t count = manifests.front().shard ? manifests.front().shard->count : 0;
    for (const Manifest& part : manifests) {
        if (part.recipe != whole.recipe)
            return fail("USE0107", "the manifests were made with different options",
                        fmt::format("'{}' and '{}'", whole.recipe, part.recipe));
        if ((part.shard ? part.shard->count : 0) != count)
            return fail("USE0107", "the manifests have different numbers of shards");
        if (part.shard && !shards.insert(part.shard->index).second)
            return fail("USE0107", fmt::format("shard {}/{} is given twice", part.shard->index, count));
        for (const ManifestAsset& asset : part.assets) {
            if (!inputs.insert(asset.input.file).second)
                return fail("USE0108", fmt::format("two manifests list the input '{}'", asset.input.file));
            for (const ManifestFile& file : asset.files)
                if (!files.insert(file.file).second)
                    return fail("USE0108", fmt::format("two inputs were written to '{}'", file.file));
        }
        whole.inputs += part.inputs;
        whole.assets.insert(whole.assets.end(), part.assets.begin(), part.assets.end());
        whole.failed.insert(whole.failed.end(), part.failed.begin(), part.failed.end());
    }
    for (std::size_t index = 1; index <= count && shards.size() < count; ++index)
        if (!shards.contains(index))
            return fail("USE0104", fmt::format("the manifest of shard {}/{} is missing", index, count));
    sort_by_name(whole);
    return whole;
}

} // namespace gonio
