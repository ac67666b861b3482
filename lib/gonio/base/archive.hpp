// Zip archives of others, which are hostile: GLDF, GDTF, USDZ.
//
// An archive is checked as a whole before anything of it is read: its directory against its entries, their bytes
// against each other, names, counts and sizes against the limits archive-…. Entries are unpacked one by one to the size
// that the directory states, and compared with their checksum. Nothing is written, and nothing outside the bytes is
// read. Fails (malformed, unsupported) with a code of gonio/base/codes/archive.hpp.
#pragma once

#include <gonio/base/result.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gonio {

// A file in an archive.
struct ArchiveEntry {
    std::string name;         // with '/' between folders, not beginning with one, without "." and ".." parts
    std::size_t size = 0;     // unpacked
    std::size_t packed = 0;   // in the archive
    std::size_t offset = 0;   // of its first byte
    std::uint16_t method = 0; // 0 stored, 8 deflated
    std::uint32_t checksum = 0;
};

// The greatest length of a name in an archive.
inline constexpr std::size_t longest_archive_name = 1024;

// The beginning of a text: at most that many bytes, and no part of a character of UTF-8 at the end.
std::string_view cut_text(std::string_view text, std::size_t longest);

// The same for messages: '?' stands for characters that a terminal might take as a command and for what is not UTF-8.
std::string shown_text(std::string_view text, std::size_t longest = 80);

// Whether the bytes begin as a zip archive does.
bool is_archive(std::string_view bytes);

class Archive {
public:
    // `bytes` must outlive the archive. `source` names it in messages.
    static Result<Archive> open(std::string_view bytes, std::string source);

    // Files in the order of the directory; folders are left out.
    std::span<const ArchiveEntry> entries() const { return entries_; }

    // Names in any case, since no two differ by that alone; nullptr if there is none.
    const ArchiveEntry* find(std::string_view name) const;

    Result<std::string> read(const ArchiveEntry& entry) const;

    // "lamp.gldf/ldc/lamp.ldt": how messages name an entry.
    std::string name_of(const ArchiveEntry& entry) const { return source_ + "/" + entry.name; }

    const std::string& source() const { return source_; }

private:
    std::string_view bytes_;
    std::string source_;
    std::vector<ArchiveEntry> entries_;
    std::vector<std::pair<std::string, std::size_t>> by_name_; // names in lower case, in order, and their entries
};

// A file to put into an archive.
struct ArchiveFile {
    std::string name;
    std::string bytes;
};

// An archive of these files, stored, without times: the same files give the same bytes. The names must be such as an
// Archive has, and all together below 4 GiB.
std::string write_archive(std::span<const ArchiveFile> files);

} // namespace gonio
