// Small questions about ASCII text, the same in every locale: bytes of 128 and above are neither letters nor blanks.
//
// Nothing here fails; functions that return a view do not allocate, and the view does not outlive the given text.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace gonio {

inline constexpr std::string_view blanks = " \t\v\f";
inline constexpr std::string_view blanks_and_line_ends = " \t\v\f\r\n";

constexpr char to_upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

constexpr char to_lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

inline std::string to_upper(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        c = to_upper(c);
    return result;
}

inline std::string to_lower(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        c = to_lower(c);
    return result;
}

constexpr bool equals_any_case(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return to_lower(x) == to_lower(y); });
}

constexpr bool starts_with_any_case(std::string_view text, std::string_view start) {
    return text.size() >= start.size() && equals_any_case(text.substr(0, start.size()), start);
}

constexpr bool ends_with_any_case(std::string_view text, std::string_view end) {
    return text.size() >= end.size() && equals_any_case(text.substr(text.size() - end.size()), end);
}

// Whether a terminal might take a part of UTF-8 text as a command: U+0000 to U+001F and U+007F to U+009F.
constexpr bool has_control_characters(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if (byte < 0x20 || byte == 0x7f) return true;
        if (byte == 0xc2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0) return true;
    }
    return false;
}

// The text without the bytes of `dropped` at its ends.
constexpr std::string_view trimmed(std::string_view text, std::string_view dropped = blanks_and_line_ends) {
    const std::size_t first = text.find_first_not_of(dropped);
    if (first == std::string_view::npos) return text.substr(text.size());
    return text.substr(first, text.find_last_not_of(dropped) - first + 1);
}

} // namespace gonio
