#include "excerpt.hpp"

#include <gonio/profile/parse.hpp>
#include <gonio/profile/scanner.hpp>
#include <gonio/profile/text_encoding.hpp>

#include "html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

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

// Where each letter of UTF-8 begins, and the end.
std::vector<std::size_t> letters_of(std::string_view text) {
    std::vector<std::size_t> begins;
    for (std::size_t i = 0; i < text.size(); ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) begins.push_back(i);
    begins.push_back(text.size());
    return begins;
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
    std::string text = to_utf8(*line);
    std::replace(text.begin(), text.end(), '\t', ' ');
    constexpr std::string_view mark = "\uFEFF"; // has no width
    if (text.starts_with(mark)) text.replace(0, mark.size(), "\uFFFD");
    const std::vector<std::size_t> letters = letters_of(text);
    const std::size_t count = letters.size() - 1;
    // A line that is not UTF-8 has a letter for each of its bytes.
    std::size_t caret = 0;
    if (location.column > 0) {
        caret = std::min<std::size_t>(location.column - 1, line->size());
        if (is_utf8(*line) && caret < line->size())
            caret =
                static_cast<std::size_t>(std::upper_bound(letters.begin(), letters.end(), caret) - letters.begin()) - 1;
        else
            caret = std::min(caret, count);
    }
    const std::size_t first = caret > shown_before ? caret - shown_before : 0;
    const std::size_t last = std::min(count, caret + shown_after + (first == 0 ? shown_before : 0));
    const std::string number = std::to_string(location.line);
    std::string shown = fmt::format("{} | {}{}{}", number, first > 0 ? "…" : "",
                                    html(std::string_view(text).substr(letters[first], letters[last] - letters[first])),
                                    last < count ? "…" : "");
    if (location.column > 0)
        shown += fmt::format("\n{} | {}<b>^</b>", std::string(number.size(), ' '),
                             std::string(caret - first + (first > 0 ? 1 : 0), ' '));
    return fmt::format("<pre class=\"source\">{}</pre>\n", shown);
}

} // namespace gonio::cli
