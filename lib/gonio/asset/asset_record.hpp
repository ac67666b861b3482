// AssetRecord: the JSON beside what import wrote of one input for one target, schema gonio.asset/2 (asset.schema.json
// describes it): of what and how it was made, so that what is up to date need not be made again.
#pragma once

#include <gonio/asset/file_record.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {

struct AssetRecord {
    std::string target;
    std::string recipe;               // all that the files depend on but the source's bytes
    std::string source_file;          // as the user named it
    std::string source_sha256;        // of its bytes, and those of all files that it names
    std::vector<FileRecord> files;    // in the target's folder, this one left out
    std::vector<std::string> instead; // LightScene::instead
};

// "NAME.asset.json".
std::string asset_record_name(std::string_view asset);

// Keys in a fixed order, two spaces of indentation, a newline at the end.
std::string asset_record_json(const AssetRecord& record);

// Nothing for what is no such record.
std::optional<AssetRecord> read_asset_record(std::string_view json);

} // namespace gonio
