#include <gonio/asset/asset_record.hpp>
#include <gonio/asset/detail/file_record_json.hpp>
#include <gonio/base/json_text.hpp>
#include <gonio/base/version.hpp>

#include <fmt/format.h>

namespace gonio {

using detail::Json;

namespace {

bool read_texts(const Json& list, std::vector<std::string>& texts) {
    if (!list.is_array()) return false;
    for (const Json& text : list) {
        if (!text.is_string()) return false;
        texts.push_back(text.as_string());
    }
    return true;
}

} // namespace

std::string asset_record_name(std::string_view asset) {
    return fmt::format("{}.asset.json", asset);
}

std::string asset_record_json(const AssetRecord& record) {
    const Json json{{"schema", "gonio.asset/2"},
                    {"tool", std::string("gonio ") + version},
                    {"target", record.target},
                    {"recipe", record.recipe},
                    {"source", {{"file", record.source_file}, {"sha256", record.source_sha256}}},
                    {"files", detail::to_json(record.files)},
                    {"instead", record.instead}};
    return json.dump(2) + "\n";
}

std::optional<AssetRecord> read_asset_record(std::string_view text) {
    const Json json = detail::parse_json(text).value_or(Json());
    const auto member = [](const Json& object, const char* key) {
        const Json* const found = object.find(key);
        return found != nullptr ? *found : Json();
    };
    const auto string = [&](const Json& object, const char* key) {
        const Json value = member(object, key);
        return value.is_string() ? value.as_string() : std::string();
    };
    AssetRecord record;
    record.target = string(json, "target");
    record.recipe = string(json, "recipe");
    record.source_file = string(member(json, "source"), "file");
    record.source_sha256 = string(member(json, "source"), "sha256");
    std::optional<std::vector<FileRecord>> files = detail::read_file_records(member(json, "files"));
    const bool whole = files && read_texts(member(json, "instead"), record.instead) &&
                       string(json, "schema") == "gonio.asset/2" && !record.source_sha256.empty();
    if (!whole) return std::nullopt;
    record.files = std::move(*files);
    return record;
}

} // namespace gonio
