#include <gonio/web/portable_text.hpp>

#include <cstdint>
#include <optional>
#include <utility>

namespace gonio::web_detail {

namespace {

// Latin-1 from U+00C0 on, letter by letter.
constexpr std::string_view letters_from_c0 = "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYTsaaaaaaaceeeeiiiidnooooo/ouuuuyty";

std::string_view ascii_of(std::uint32_t c, char& buffer) {
    if (c >= 0xC0 && c <= 0xFF) {
        if (c == 0xC6) return "AE";
        if (c == 0xE6) return "ae";
        if (c == 0xDF) return "ss";
        buffer = letters_from_c0[c - 0xC0];
        return {&buffer, 1};
    }
    switch (c) {
    case 0xA0:
        return " ";
    case 0xA9:
        return "(C)";
    case 0xAE:
        return "(R)";
    case 0xB0:
        return "deg";
    case 0xB1:
        return "+-";
    case 0xB2:
        return "2";
    case 0xB3:
        return "3";
    case 0xB5:
    case 0x3BC:
        return "u";
    case 0x152:
        return "OE";
    case 0x153:
        return "oe";
    case 0x3A9:
        return "Ohm";
    case 0x2013:
    case 0x2014:
    case 0x2212:
        return "-";
    case 0x2018:
    case 0x2019:
        return "'";
    case 0x201C:
    case 0x201D:
    case 0x201E:
        return "\"";
    case 0x2026:
        return "...";
    case 0x20AC:
        return "EUR";
    case 0x2122:
        return "(TM)";
    default:
        return "?";
    }
}

// Code page 1252 where it differs from Latin-1, for the characters handled above.
std::uint32_t of_1252(unsigned char byte) {
    switch (byte) {
    case 0x80:
        return 0x20AC;
    case 0x84:
    case 0x93:
    case 0x94:
        return 0x201C;
    case 0x85:
        return 0x2026;
    case 0x8C:
        return 0x152;
    case 0x91:
    case 0x92:
        return 0x2019;
    case 0x96:
    case 0x97:
        return 0x2013;
    case 0x99:
        return 0x2122;
    case 0x9C:
        return 0x153;
    default:
        return byte;
    }
}

// The character that begins at `at`; moves `at` past it. Empty if the bytes are not UTF-8.
std::optional<std::uint32_t> next_utf8(std::string_view text, std::size_t& at) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
    const std::uint32_t lead = byte(at);
    const std::size_t more = lead < 0x80 ? 0 : lead >= 0xC2 && lead < 0xE0 ? 1 : lead >= 0xE0 && lead < 0xF0 ? 2 : 3;
    if ((lead >= 0x80 && lead < 0xC2) || lead > 0xF4 || at + more >= text.size()) return std::nullopt;
    std::uint32_t c = more == 0 ? lead : lead & (0x3FU >> more);
    for (std::size_t i = 1; i <= more; ++i) {
        if ((byte(at + i) & 0xC0U) != 0x80U) return std::nullopt;
        c = c << 6U | (byte(at + i) & 0x3FU);
    }
    at += more + 1;
    return c;
}

} // namespace

bool make_ascii(std::string& text) {
    std::string ascii;
    bool utf8 = true;
    for (std::size_t i = 0; utf8 && i < text.size();)
        utf8 = next_utf8(text, i).has_value();
    bool changed = false;
    for (std::size_t i = 0; i < text.size();) {
        const std::uint32_t c = utf8 ? *next_utf8(text, i) : of_1252(static_cast<unsigned char>(text[i++]));
        if (c < 0x80) {
            ascii += c == '\t' ? ' ' : static_cast<char>(c);
            continue;
        }
        char buffer = 0;
        ascii += ascii_of(c, buffer);
        changed = true;
    }
    text = std::move(ascii);
    return changed;
}

std::string in_lines_of(std::string_view text, std::size_t first, std::size_t others) {
    std::string lines;
    std::size_t longest = first;
    while (true) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        while (line.size() > longest) {
            const std::size_t blank = line.rfind(' ', longest);
            const std::size_t cut = blank == std::string_view::npos || blank == 0 ? longest : blank;
            lines += line.substr(0, cut);
            lines += '\n';
            line.remove_prefix(cut);
            while (!line.empty() && line.front() == ' ')
                line.remove_prefix(1);
            longest = others;
        }
        lines += line;
        if (end == std::string_view::npos) return lines;
        lines += '\n';
        longest = others;
        text.remove_prefix(end + 1);
    }
}

} // namespace gonio::web_detail
