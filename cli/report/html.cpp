#include "html.hpp"

#include <gonio/base/markup.hpp>
#include <gonio/profile/text_encoding.hpp>

namespace gonio::cli {

namespace {

constexpr std::string_view replacement = "\uFFFD";

// The bytes of the character at the start that is shown as U+FFFD; 0 if it is shown as it is.
std::size_t unwanted(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const unsigned first = byte(0);
    if (first == 0x7FU || (first < 0x20U && first != '\n' && first != '\t' && first != '\r')) return 1;
    if (first == 0xC2U && byte(1) < 0xA0U) return 2; // U+0080 to U+009F
    if (first != 0xE2U) return 0;
    const bool embeds = byte(1) == 0x80U && byte(2) >= 0xAAU && byte(2) <= 0xAEU;   // U+202A to U+202E
    const bool isolates = byte(1) == 0x81U && byte(2) >= 0xA6U && byte(2) <= 0xA9U; // U+2066 to U+2069
    return embeds || isolates ? 3 : 0;
}

} // namespace

std::string plain_text(std::string_view bytes) {
    const std::string text = to_utf8(bytes);
    std::string out;
    out.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        if (const std::size_t width = unwanted(std::string_view(text).substr(i)); width > 0) {
            out += replacement;
            i += width;
        } else {
            out += text[i++];
        }
    }
    return out;
}

std::string html(std::string_view bytes) {
    const std::string text = plain_text(bytes);
    std::string out;
    out.reserve(text.size() + text.size() / 8);
    for (const char c : text) {
        if (const std::string_view entity = markup_entity(c); !entity.empty())
            out += entity;
        else if (c == '\'')
            out += "&#39;";
        else if (c != '\r') // a line end by itself, in HTML
            out += c;
    }
    return out;
}

std::string html_start(std::string_view bytes, std::size_t most) {
    std::string text = to_utf8(bytes);
    if (text.size() <= most) return html(text);
    std::size_t end = most;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
        --end;
    text.resize(end);
    return html(text) + "…";
}

} // namespace gonio::cli
