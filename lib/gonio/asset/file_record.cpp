#include <gonio/asset/content_hash.hpp>
#include <gonio/asset/detail/file_record_json.hpp>
#include <gonio/asset/file_record.hpp>

#include <utility>

namespace gonio {

FileRecord file_record(std::string file, std::string_view bytes) {
    return {std::move(file), bytes.size(), sha256(bytes)};
}

bool matches(const FileRecord& record, std::string_view bytes) {
    return bytes.size() == record.size_bytes && sha256(bytes) == record.sha256;
}

bool is_plain_name(std::string_view name) {
    return !name.empty() && name != "." && name != ".." && name.find('/') == std::string_view::npos &&
           name.find('\0') == std::string_view::npos;
}

namespace detail {

Json to_json(const std::vector<FileRecord>& records) {
    Json list = Json::array();
    for (const FileRecord& record : records)
        list.push_back({{"file", record.file}, {"size_bytes", record.size_bytes}, {"sha256", record.sha256}});
    return list;
}

std::optional<std::vector<FileRecord>> read_file_records(const Json& json) {
    if (!json.is_array()) return std::nullopt;
    std::vector<FileRecord> records;
    for (const Json& entry : json) {
        const Json* const file = entry.find("file");
        const Json* const size = entry.find("size_bytes");
        const Json* const hash = entry.find("sha256");
        const bool whole = file != nullptr && file->is_string() && size != nullptr && size->is_unsigned() &&
                           hash != nullptr && hash->is_string();
        if (!whole || !is_plain_name(file->as_string())) return std::nullopt;
        records.push_back({file->as_string(), size->as_uint64(), hash->as_string()});
    }
    return records;
}

} // namespace detail

} // namespace gonio
