// FileRecord: which bytes a file had when it was written. Sidecars and asset records carry one for each of their files,
// because a reader may meet files of two versions: a process was killed between two renames, or two wrote side by side.
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

// Whether these are the bytes that were recorded.
bool matches(const FileRecord& record, std::string_view bytes);

// Whether the name is that of a file in the folder of the record itself: not empty, no '/', not "." or "..".
bool is_plain_name(std::string_view name);

} // namespace gonio
