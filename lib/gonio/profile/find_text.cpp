// Finds the text in the bytes of a file, and checks that it is text at all.
#include <gonio/base/text.hpp>
#include <gonio/profile/parse.hpp>
#include <gonio/profile/scanner.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace gonio::profile_detail {

namespace {

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}

// What often stands under the name of a photometric file, by its first bytes; capitals do not matter.
struct OtherFile {
    std::string_view begins;
    std::string_view name;
    std::string_view hint = {};
};

constexpr std::string_view extract = "extract the profile from it";
constexpr std::string_view download = "the download failed: open the file in a browser to see why";
constexpr OtherFile other_files[] = {{"\x89PNG", "a PNG picture"},
                                     {"\xFF\xD8\xFF", "a JPEG picture"},
                                     {"GIF8", "a GIF picture"},
                                     {"%PDF-", "a PDF document"},
                                     {"{\\rtf", "an RTF document", "save it as plain text"},
                                     {"PK\x03\x04", "a ZIP archive", extract},
                                     {"Rar!", "a RAR archive", extract},
                                     {"\x1F\x8B", "a gzip archive", extract},
                                     {"<!doctype html", "a web page", download},
                                     {"<html", "a web page", download},
                                     {"SPV1.", "an SPV file", "export it as IES or EULUMDAT"}};

const OtherFile* other_file(std::string_view bytes) {
    for (const OtherFile& other : other_files)
        if (starts_with_any_case(bytes, other.begins)) return &other;
    return nullptr;
}

} // namespace

// A byte order mark, or NUL in every second one of the first bytes: no other text has these.
Utf16 utf16_of(std::string_view bytes) {
    if (bytes.starts_with("\xFF\xFE")) return Utf16::little_endian;
    if (bytes.starts_with("\xFE\xFF")) return Utf16::big_endian;
    constexpr std::size_t looked_at = 8;
    if (bytes.size() < looked_at) return Utf16::no;
    const auto alternates = [&](std::size_t nul) {
        for (std::size_t i = 0; i < looked_at; ++i)
            if ((bytes[i] == '\0') != (i % 2 == nul)) return false;
        return true;
    };
    return alternates(1) ? Utf16::little_endian : alternates(0) ? Utf16::big_endian : Utf16::no;
}

bool begins_as_other_file(std::string_view bytes) {
    return bytes.starts_with(utf8_mark) || bytes.starts_with("\xFE\xFF") || bytes.starts_with("\xFF\xFE") ||
           other_file(bytes) != nullptr;
}

// Removes marks, Ctrl-Z and NUL padding from both ends; fails if the rest is not text.
Result<TextRange> find_text(std::string_view bytes, Report& report) {
    TextRange text{0, bytes.size()};
    if (bytes.starts_with(utf8_mark)) report.add("PRF0104", 0, "the file begins with a byte order mark");
    while (bytes.substr(text.begin).starts_with(utf8_mark))
        text.begin += utf8_mark.size();
    const std::string_view begins = bytes.substr(text.begin);
    if (begins.starts_with("\xFE\xFF") || begins.starts_with("\xFF\xFE"))
        return report.fail("PRF0106", text.begin, "a UTF-16 mark follows that of UTF-8", "save it as UTF-8");
    while (text.end > text.begin && bytes[text.end - 1] == '\0')
        --text.end;
    const bool nothing = std::all_of(bytes.begin(), bytes.end(), [](char c) { return is_blank(c) || is_line_end(c); });
    if (nothing) return report.fail("PRF0101", 0, "the file is empty");
    if (const OtherFile* const other = other_file(begins))
        return report.fail("PRF0102", text.begin, fmt::format("not a photometric file but {}", other->name),
                           std::string(other->hint));
    // Text never contains NUL and every other file does; a stray control byte in a remark does no harm. Ctrl-Z counts
    // as an end only if the bytes before it are text.
    const std::size_t ctrl_z = std::min(bytes.substr(0, text.end).find('\x1A', text.begin), text.end);
    if (const std::size_t i = bytes.substr(0, ctrl_z).find('\0', text.begin); i != std::string_view::npos)
        return report.fail("PRF0102", i, "not a photometric file: text has no NUL bytes");
    const auto is_data = [](char c) { return !is_blank(c) && !is_line_end(c) && c != '\0' && c != '\x1A'; };
    const auto* const after = std::find_if(bytes.begin() + static_cast<std::ptrdiff_t>(ctrl_z), bytes.end(), is_data);
    if (text.end == text.begin || ctrl_z == text.begin)
        return report.fail("PRF0102", text.begin, "not a photometric file: it holds no text");
    if (after != bytes.end())
        report.add("PRF0105", static_cast<std::size_t>(after - bytes.begin()),
                   "data after Ctrl-Z, the end of the text");
    text.end = ctrl_z;
    return text;
}

} // namespace gonio::profile_detail
