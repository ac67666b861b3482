// AssetRecord: the JSON record of what import wrote for one input and one target, schema gonio.asset/2 (described by
// asset.schema.json). It states the source and the options, so that files that are up to date need not be made again.
#pragma once

#include <gonio/asset/file_record.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {

struct AssetRecord {
    std::string target;
    std::string recipe;               // everything that the files depend on except the source's bytes
    std::string source_file;          // as the user named it
    std::string source_sha256;        // of its bytes and those of all files that it names
    std::vector<FileRecord> files;    // in the target's folder, without this record
    std::vector<std::string> instead; // LightScene::instead
};

// "NAME.asset.json".
std::string asset_record_name(std::string_view asset);

// Keys in a fixed order, two spaces of indentation, a newline at the end.
std::string asset_record_json(const AssetRecord& record);

// Nothing if the text is not such a record.
std::optional<AssetRecord> read_asset_record(std::string_view json);

} // namespace gonio
