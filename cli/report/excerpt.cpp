#include "excerpt.hpp"

#include <gonio/profile/parse.hpp>
#include <gonio/profile/scanner.hpp>
#include <gonio/profile/text_encoding.hpp>

#include "html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace gonio::cli {

namespace {

constexpr std::size_t shown_before = 48; // letters before the column, and after it
constexpr std::size_t shown_after = 32;

std::optional<std::string_view> line_in(std::string_view bytes, std::uint32_t number) {
    profile_detail::LineScanner lines(bytes, 0, bytes.size());
    std::string_view text;
    for (std::uint32_t line = 1; line <= number; ++line) {
        if (lines.at_end()) return std::nullopt;
        text = lines.next().text;
    }
    return text;
}

} // namespace

std::string excerpt(std::string_view bytes, const Location& location) {
    if (location.line == 0) return {};
    // Readers of UTF-16 count in the UTF-8 that they make of it.
    std::string converted;
    if (const profile_detail::Utf16 utf16 = profile_detail::utf16_of(bytes); utf16 != profile_detail::Utf16::no) {
        converted = utf16_to_utf8(bytes, utf16 == profile_detail::Utf16::big_endian);
        bytes = converted;
    }
    const std::optional<std::string_view> line = line_in(bytes, location.line);
    if (!line) return {};
    // A line that is not UTF-8 has a letter for each of its bytes.
    const bool has_letters = is_utf8(*line);
    const auto within_letter = [&](std::size_t byte) {
        return has_letters && byte < line->size() && (static_cast<unsigned char>((*line)[byte]) & 0xC0U) == 0x80U;
    };
    const std::size_t column = location.column == 0 ? 0 : std::min<std::size_t>(location.column - 1, line->size());
    std::size_t first = column;
    std::size_t before = 0; // letters shown before the column
    for (; first > 0 && before < shown_before; ++before)
        do
            --first;
        while (first > 0 && within_letter(first));
    std::size_t last = column;
    for (std::size_t after = 0; last < line->size() && after < shown_before + shown_after - before; ++after)
        do
            ++last;
        while (within_letter(last));
    std::string text = to_utf8(line->substr(first, last - first));
    std::replace(text.begin(), text.end(), '\t', ' ');
    constexpr std::string_view mark = "\uFEFF"; // has no width
    if (text.starts_with(mark)) text.replace(0, mark.size(), "\uFFFD");
    const std::string number = std::to_string(location.line);
    std::string shown =
        fmt::format("{} | {}{}{}", number, first > 0 ? "…" : "", html(text), last < line->size() ? "…" : "");
    if (location.column > 0)
        shown += fmt::format("\n{} | {}<b>^</b>", std::string(number.size(), ' '),
                             std::string(before + (first > 0 ? 1 : 0), ' '));
    return fmt::format("<pre class=\"source\">{}</pre>\n", shown);
}

} // namespace gonio::cli
