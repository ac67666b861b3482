// Finds the text in the bytes of a file, and checks that it is text at all.
#include <gonio/profile/parse.hpp>
#include <gonio/profile/scanner.hpp>

#include <algorithm>

namespace gonio::profile_detail {

namespace {

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

bool is_line_end(char c) {
    return c == '\n' || c == '\r';
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
    // Text never contains NUL and every other file does; a stray control byte in a remark does no harm. Ctrl-Z counts
    // as an end only if the bytes before it are text.
    const std::size_t ctrl_z = std::min(bytes.substr(0, text.end).find('\x1A', text.begin), text.end);
    if (const std::size_t i = bytes.substr(0, ctrl_z).find('\0', text.begin); i != std::string_view::npos)
        return report.fail("PRF0102", i, "not a photometric file: text has no NUL bytes");
    if (begins.starts_with("\x89PNG"))
        return report.fail("PRF0102", text.begin, "not a photometric file but a PNG picture");
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
