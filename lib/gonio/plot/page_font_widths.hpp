// Widths of the letters of the fonts of pages. Internal to this room.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace gonio::plot_detail {

// A run of code points, and where their widths begin in the tables.
struct LetterRange {
    char32_t first = 0;
    char32_t last = 0;
    std::uint16_t at = 0;
};

// The letters that both fonts have widths for, ascending.
std::span<const LetterRange> letter_ranges();

// In 2048ths of the font size. Empty for a letter that the fonts do not have, or that needs more than its own glyph:
// Arabic, Hebrew, Devanagari.
std::optional<std::uint16_t> letter_width(char32_t letter, bool bold);

} // namespace gonio::plot_detail
