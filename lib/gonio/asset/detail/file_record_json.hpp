// FileRecords in JSON: [{"file": …, "size_bytes": …, "sha256": …}, …].
#pragma once

#include <gonio/asset/file_record.hpp>
#include <gonio/base/json.hpp>

#include <optional>
#include <vector>

namespace gonio::detail {

Json to_json(const std::vector<FileRecord>& records);

// Nothing where one is not whole or its file does not have a plain name.
std::optional<std::vector<FileRecord>> read_file_records(const Json& json);

} // namespace gonio::detail
