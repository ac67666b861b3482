// Text of printed pages: letters of DejaVu Sans, whose widths are known here, so that a page is laid out the same
// without the font as with it.
//
// Latin, Greek and Cyrillic letters and the signs of the field. Text that comes from files is hostile: it goes through
// page_text().
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gonio {

// Text as a page can show it.
struct PageText {
    std::string text;         // UTF-8, one line
    std::size_t replaced = 0; // letters that the font does not have, shown as U+FFFD
};

// Bytes of any encoding as to_utf8() has them. Blanks and line ends become one space. Control characters, marks that
// reverse the order of letters, and letters that the font does not have become U+FFFD.
PageText page_text(std::string_view bytes);

// The width of a line of UTF-8 at a font size, in the unit of the size.
double page_text_width(std::string_view text, double size, bool bold = false);

// The text, or as much of it as fits the width with an ellipsis at its end.
std::string fitted_text(std::string_view text, double width, double size, bool bold = false);

} // namespace gonio
