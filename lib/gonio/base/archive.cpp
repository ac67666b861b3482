#include <gonio/base/archive.hpp>
#include <gonio/base/archive_xml.hpp>
#include <gonio/base/codes/archive.hpp>
#include <gonio/base/inflate.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace gonio {

namespace {

// Records of a zip archive begin with these (PKWARE, APPNOTE 4.3).
constexpr std::string_view local_mark = "PK\x03\x04";
constexpr std::string_view directory_mark = "PK\x01\x02";
constexpr std::string_view end_mark = "PK\x05\x06";
constexpr std::size_t local_size = 30;
constexpr std::size_t directory_size = 46;
constexpr std::size_t end_size = 22;
constexpr std::size_t longest_comment = 0xffff;

std::uint32_t number16(std::string_view bytes, std::size_t at) {
    return static_cast<unsigned char>(bytes[at]) | static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + 1]))
                                                       << 8U;
}

std::uint32_t number32(std::string_view bytes, std::size_t at) {
    return number16(bytes, at) | number16(bytes, at + 2) << 16U;
}

// How many bytes of a text are its first character, if it begins with one of UTF-8 that a terminal only shows; else 0.
std::size_t plain_character(std::string_view text) {
    const auto byte = [&](std::size_t at) -> unsigned {
        return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U;
    };
    if (byte(0) < 0x80) return byte(0) < 0x20 || byte(0) == 0x7f ? 0 : 1;
    const std::size_t size = byte(0) < 0xc2 ? 0 : byte(0) < 0xe0 ? 2 : byte(0) < 0xf0 ? 3 : byte(0) < 0xf5 ? 4 : 0;
    for (std::size_t i = 1; i < size; ++i)
        if ((byte(i) & 0xc0U) != 0x80U) return 0;
    const unsigned second = byte(1);
    const bool is_control = byte(0) == 0xc2 && second < 0xa0;
    const bool is_wrong = (byte(0) == 0xe0 && second < 0xa0) || (byte(0) == 0xed && second >= 0xa0) ||
                          (byte(0) == 0xf0 && second < 0x90) || (byte(0) == 0xf4 && second >= 0x90);
    return is_control || is_wrong ? 0 : size;
}

// Why no file may have that name; empty if it may. Some programs write '\' between folders.
std::string_view fault_of(std::string_view name) {
    if (name.empty()) return "is empty";
    if (name.size() > longest_archive_name) return "is longer than 1024 bytes";
    static_assert(longest_archive_name == 1024);
    if (has_control_characters(name)) return "has control characters";
    if (name.front() == '/') return "is absolute";
    if (name.find(':') != std::string_view::npos) return "has a ':', as that of a drive or a stream";
    while (true) {
        const std::size_t end = std::min(name.find('/'), name.size());
        const std::string_view part = name.substr(0, end);
        if (part == ".." || part == ".") return "climbs through folders";
        if (part.empty()) return "has an empty part";
        if (end + 1 >= name.size()) return {};
        name.remove_prefix(end + 1);
    }
}

class ArchiveReader {
public:
    ArchiveReader(std::string_view bytes, const std::string& source) : bytes_(bytes), source_(source) {}

    Result<std::vector<ArchiveEntry>> read() {
        const std::optional<std::size_t> end = find_end();
        if (!end)
            return wrong("ARC0101", "the archive has no directory at its end: it is cut off, or is not a zip archive");
        const std::string_view record = bytes_.substr(*end, end_size);
        if (number16(record, 4) != 0 || number16(record, 6) != 0 || number16(record, 8) != number16(record, 10))
            return wrong("ARC0106", "the archive is one of several parts");
        const std::size_t count = number16(record, 10);
        const std::size_t size = number32(record, 12);
        begin_ = number32(record, 16);
        if (count == 0xffff || size == 0xffffffff || begin_ == 0xffffffff)
            return wrong("ARC0106", "the archive is ZIP64, which gonio does not read");
        if (count > limit("archive-entries").value)
            return wrong("ARC0102",
                         fmt::format("{} entries are more than {}", count, to_text(limit("archive-entries"))),
                         std::string(limits_hint));
        if (begin_ > *end || size > *end - begin_)
            return wrong("ARC0101", "the directory of the archive is not where its end says");
        std::size_t at = begin_;
        const std::size_t stop = begin_ + size;
        for (std::size_t i = 0; i < count; ++i) {
            Result<std::size_t> next = read_entry(at, stop);
            if (!next) return pass_on(next);
            at = *next;
        }
        if (at != stop) return wrong("ARC0101", "the directory of the archive has bytes behind its last entry");
        if (Result<void> checked = check_overlap(); !checked) return pass_on(checked);
        return std::move(entries_);
    }

private:
    Unexpected wrong(ArchiveCode code, std::string message, std::string hint = {}) {
        return archive_error(code, {source_, 0, 0}, std::move(message), std::move(hint));
    }

    // The record at the end, before a comment that ends with the file.
    std::optional<std::size_t> find_end() const {
        if (bytes_.size() < end_size) return std::nullopt;
        const std::size_t first =
            bytes_.size() > end_size + longest_comment ? bytes_.size() - end_size - longest_comment : 0;
        for (std::size_t at = bytes_.size() - end_size;; --at) {
            if (bytes_.substr(at, 4) == end_mark && at + end_size + number16(bytes_, at + 20) == bytes_.size())
                return at;
            if (at == first) return std::nullopt;
        }
    }

    // An entry of the directory, with its own head; returns where the next one begins.
    Result<std::size_t> read_entry(std::size_t at, std::size_t stop) {
        if (stop - at < directory_size || bytes_.substr(at, 4) != directory_mark)
            return wrong("ARC0101", "the directory of the archive is broken");
        const std::size_t name_size = number16(bytes_, at + 28);
        const std::size_t rest = std::size_t{number16(bytes_, at + 30)} + number16(bytes_, at + 32);
        if (stop - at - directory_size < name_size + rest)
            return wrong("ARC0101", "the directory of the archive is broken");
        ArchiveEntry entry;
        const std::string_view written = bytes_.substr(at + directory_size, name_size);
        entry.name = written;
        std::replace(entry.name.begin(), entry.name.end(), '\\', '/');
        entry.method = static_cast<std::uint16_t>(number16(bytes_, at + 10));
        entry.checksum = number32(bytes_, at + 16);
        entry.packed = number32(bytes_, at + 20);
        entry.size = number32(bytes_, at + 24);
        const std::size_t head = number32(bytes_, at + 42);
        const std::string name = shown_text(written);
        if (const std::string_view fault = fault_of(entry.name); !fault.empty())
            return wrong("ARC0103", fmt::format("the name '{}' in the archive {}", name, fault));
        constexpr std::uint32_t encrypted = 0x2041; // encryption, strong encryption, masked heads
        if ((number16(bytes_, at + 8) & encrypted) != 0)
            return wrong("ARC0105", fmt::format("'{}' in the archive is encrypted", name));
        if (entry.packed == 0xffffffff || entry.size == 0xffffffff || head == 0xffffffff)
            return wrong("ARC0106", "the archive is ZIP64, which gonio does not read");
        if (Result<void> checked = check_size(entry, name); !checked) return pass_on(checked);
        // What the entry says of itself must be the same; sizes may stand behind it instead.
        if (head > begin_ || begin_ - head < local_size || bytes_.substr(head, 4) != local_mark)
            return wrong("ARC0101", fmt::format("'{}' is not where the directory of the archive says", name));
        if ((number16(bytes_, head + 6) & encrypted) != 0)
            return wrong("ARC0105", fmt::format("'{}' in the archive is encrypted", name));
        const std::size_t own_name = number16(bytes_, head + 26);
        entry.offset = head + local_size + own_name + number16(bytes_, head + 28);
        if (entry.offset > begin_ || entry.packed > begin_ - entry.offset)
            return wrong("ARC0101", fmt::format("'{}' in the archive is cut off", name));
        if (bytes_.substr(head + local_size, own_name) != written || number16(bytes_, head + 8) != entry.method)
            return wrong(
                "ARC0101",
                fmt::format("'{}' has another name or method in its own head than in the directory of the archive",
                            name));
        ranges_.emplace_back(head, entry.offset + entry.packed);
        if (!entry.name.ends_with('/')) entries_.push_back(std::move(entry));
        return at + directory_size + name_size + rest;
    }

    Result<void> check_size(const ArchiveEntry& entry, const std::string& name) {
        if (entry.size > limit("archive-entry-bytes").value)
            return wrong("ARC0102",
                         fmt::format("'{}' in the archive unpacks to {} bytes, more than {}", name, entry.size,
                                     to_text(limit("archive-entry-bytes"))),
                         std::string(limits_hint));
        if (entry.size > mebibyte && entry.size / limit("archive-ratio").value > entry.packed)
            return wrong("ARC0102",
                         fmt::format("'{}' in the archive unpacks to more than {} its bytes, the limit 'archive-ratio'",
                                     name, amount_of(limit("archive-ratio"))),
                         std::string(limits_hint));
        unpacked_ += entry.size;
        if (unpacked_ > limit("archive-unpacked-bytes").value)
            return wrong("ARC0102",
                         fmt::format("the archive unpacks to more than {}", to_text(limit("archive-unpacked-bytes"))),
                         std::string(limits_hint));
        return {};
    }

    // Entries that share bytes unpack to far more than the archive seems to hold.
    Result<void> check_overlap() {
        std::sort(ranges_.begin(), ranges_.end());
        for (std::size_t i = 1; i < ranges_.size(); ++i)
            if (ranges_[i].first < ranges_[i - 1].second) return wrong("ARC0101", "entries of the archive share bytes");
        return {};
    }

    std::string_view bytes_;
    const std::string& source_;
    std::size_t begin_ = 0; // of the directory
    std::uint64_t unpacked_ = 0;
    std::vector<ArchiveEntry> entries_;
    std::vector<std::pair<std::size_t, std::size_t>> ranges_; // of bytes, with the heads
};

void append16(std::string& bytes, std::size_t number) {
    bytes += static_cast<char>(number & 255U);
    bytes += static_cast<char>(number >> 8U & 255U);
}

void append32(std::string& bytes, std::size_t number) {
    append16(bytes, number & 0xffffU);
    append16(bytes, number >> 16U & 0xffffU);
}

} // namespace

std::string_view cut_text(std::string_view text, std::size_t longest) {
    if (text.size() <= longest) return text;
    std::size_t end = longest;
    while (end > 0 && longest - end < 3 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U)
        --end;
    return text.substr(0, end);
}

std::string shown_text(std::string_view text, std::size_t longest) {
    std::string plain;
    for (std::string_view rest = cut_text(text, longest); !rest.empty();) {
        const std::size_t size = plain_character(rest);
        size == 0 ? plain += '?' : plain += rest.substr(0, size);
        rest.remove_prefix(std::max<std::size_t>(size, 1));
    }
    return plain;
}

bool is_archive(std::string_view bytes) {
    // Text may begin with these marks, too, but has no zeros: those of the method, and of the numbers of parts.
    constexpr std::size_t method_high = 9;
    constexpr std::size_t parts = 4;
    return (bytes.starts_with(local_mark) && bytes.size() > method_high && bytes[method_high] == '\0') ||
           (bytes.starts_with(end_mark) && bytes.size() >= end_size && bytes[parts] == '\0');
}

Result<Archive> Archive::open(std::string_view bytes, std::string source) {
    Archive archive;
    archive.bytes_ = bytes;
    archive.source_ = std::move(source);
    Result<std::vector<ArchiveEntry>> entries = ArchiveReader(bytes, archive.source_).read();
    if (!entries) return pass_on(entries);
    archive.entries_ = std::move(*entries);
    std::vector<std::pair<std::string, std::size_t>>& names = archive.by_name_;
    names.reserve(archive.entries_.size());
    for (std::size_t i = 0; i < archive.entries_.size(); ++i)
        names.emplace_back(to_lower(archive.entries_[i].name), i);
    std::sort(names.begin(), names.end());
    for (std::size_t i = 1; i < names.size(); ++i)
        if (names[i].first == names[i - 1].first)
            return archive_error("ARC0104", {archive.source_, 0, 0},
                                 fmt::format("the archive has two files named '{}', in upper or lower case",
                                             shown_text(names[i].first)));
    return archive;
}

const ArchiveEntry* Archive::find(std::string_view name) const {
    if (name.size() > longest_archive_name) return nullptr;
    const std::string wanted = to_lower(name);
    const auto found = std::lower_bound(by_name_.begin(), by_name_.end(), wanted,
                                        [](const auto& a, const std::string& b) { return a.first < b; });
    if (found == by_name_.end() || found->first != wanted) return nullptr;
    return &entries_[found->second];
}

Result<std::string> Archive::read(const ArchiveEntry& entry) const {
    const std::string_view packed = bytes_.substr(entry.offset, entry.packed);
    if (entry.method != 0 && entry.method != 8)
        return archive_error(
            "ARC0106", {name_of(entry), 0, 0},
            fmt::format("compressed by method {}: gonio reads stored and deflated files", entry.method));
    std::optional<std::string> bytes;
    if (entry.method == 8)
        bytes = inflate(packed, entry.size);
    else if (entry.packed == entry.size)
        bytes = std::string(packed);
    if (!bytes || crc32(*bytes) != entry.checksum)
        return archive_error("ARC0101", {name_of(entry), 0, 0}, "the file does not unpack to what the archive states");
    return std::move(*bytes);
}

std::string write_archive(std::span<const ArchiveFile> files) {
    constexpr std::size_t version = 20;
    constexpr std::size_t utf8_names = 0x0800;
    constexpr std::size_t first_day = 0x0021; // 1 January 1980, where a zip's time begins
    std::string bytes;
    std::string directory;
    for (const ArchiveFile& file : files) {
        const std::size_t head = bytes.size();
        std::string about; // the same in both places
        append16(about, version);
        append16(about, utf8_names);
        append16(about, 0); // stored
        append16(about, 0);
        append16(about, first_day);
        append32(about, crc32(file.bytes));
        append32(about, file.bytes.size());
        append32(about, file.bytes.size());
        append16(about, file.name.size());
        append16(about, 0);
        bytes.append(local_mark).append(about).append(file.name).append(file.bytes);
        directory.append(directory_mark);
        append16(directory, version);
        directory.append(about);
        append16(directory, 0); // comment, part, attributes
        append16(directory, 0);
        append16(directory, 0);
        append32(directory, 0);
        append32(directory, head);
        directory.append(file.name);
    }
    const std::size_t begin = bytes.size();
    bytes.append(directory).append(end_mark);
    append32(bytes, 0);
    append16(bytes, files.size());
    append16(bytes, files.size());
    append32(bytes, directory.size());
    append32(bytes, begin);
    append16(bytes, 0);
    return bytes;
}

} // namespace gonio
