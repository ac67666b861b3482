// FileRecord: which bytes a file had when it was written. Sidecars and asset records have one for each of their files,
// because a reader may find files of two versions if a process was killed between two renames or two processes wrote at
// the same time.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gonio {

struct FileRecord {
    std::string file; // its name, without a folder
    std::uint64_t size_bytes = 0;
    std::string sha256;

    bool operator==(const FileRecord&) const = default;
};

FileRecord file_record(std::string file, std::string_view bytes);

// Whether `bytes` are those that were recorded.
bool matches(const FileRecord& record, std::string_view bytes);

// Whether the name is that of a file in the record's own folder: not empty, no '/', not "." or "..".
bool is_plain_name(std::string_view name);

} // namespace gonio
