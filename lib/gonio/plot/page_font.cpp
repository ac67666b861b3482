#include <gonio/plot/page_font.hpp>
#include <gonio/plot/page_font_widths.hpp>
#include <gonio/profile/text_encoding.hpp>

#include <cstdint>

namespace gonio {

using namespace plot_detail;

namespace {

constexpr std::string_view replacement = "\uFFFD";
constexpr std::string_view ellipsis = "…";
constexpr double units_per_size = 2048.0;

struct Letter {
    char32_t code = 0;
    std::size_t bytes = 1;
};

// The first letter of well-formed UTF-8; text is not empty.
Letter first_letter(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<char32_t>(static_cast<unsigned char>(text[i])) : char32_t{0x80};
    };
    const char32_t lead = byte(0);
    if (lead < 0xC0) return {lead, 1};
    const std::size_t count = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    char32_t code = lead & (0x7FU >> count);
    for (std::size_t i = 1; i < count; ++i)
        code = code << 6U | (byte(i) & 0x3FU);
    return {code, count < text.size() ? count : text.size()};
}

// Of a letter that is not there: the one that stands for it.
double width_of(char32_t code, bool bold) {
    constexpr std::uint16_t usual = 2098; // U+FFFD
    return letter_width(code, bold).value_or(letter_width(0xFFFD, bold).value_or(usual)) / units_per_size;
}

} // namespace

PageText page_text(std::string_view bytes) {
    PageText page;
    bool is_after_blank = true; // none at the start
    const std::string utf8 = to_utf8(bytes);
    std::string_view rest = utf8;
    while (!rest.empty()) {
        const Letter letter = first_letter(rest);
        const std::string_view as_is = rest.substr(0, letter.bytes);
        rest.remove_prefix(letter.bytes);
        const bool is_blank = letter.code == ' ' || (letter.code >= '\t' && letter.code <= '\r') || letter.code == 0xA0;
        if (is_blank) {
            if (!is_after_blank) page.text += ' ';
            is_after_blank = true;
            continue;
        }
        is_after_blank = false;
        if (letter.code == 0xAD) continue; // a soft hyphen shows nothing
        if (letter_width(letter.code, false) && letter.code != 0xFFFD) {
            page.text += as_is;
        } else {
            page.text += replacement;
            ++page.replaced;
        }
    }
    while (page.text.ends_with(' '))
        page.text.pop_back();
    return page;
}

double page_text_width(std::string_view text, double size, bool bold) {
    double width = 0.0;
    while (!text.empty()) {
        const Letter letter = first_letter(text);
        width += width_of(letter.code, bold);
        text.remove_prefix(letter.bytes);
    }
    return size * width;
}

std::string fitted_text(std::string_view text, double width, double size, bool bold) {
    if (page_text_width(text, size, bold) <= width) return std::string(text);
    const double room = width - page_text_width(ellipsis, size, bold);
    double used = 0.0;
    std::size_t end = 0;
    while (end < text.size()) {
        const Letter letter = first_letter(text.substr(end));
        used += size * width_of(letter.code, bold);
        if (used > room) break;
        end += letter.bytes;
    }
    while (end > 0 && text[end - 1] == ' ')
        --end;
    return std::string(text.substr(0, end)) + std::string(ellipsis);
}

} // namespace gonio
