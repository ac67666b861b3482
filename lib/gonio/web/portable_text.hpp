// Text in the portable dialect: ASCII, in lines that every reader accepts whole. Internal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gonio::web_detail {

// The input is UTF-8, or code page 1252 if the bytes are not UTF-8. Letters lose their accents, units are spelt out,
// all else becomes '?'; tabs become blanks. Returns whether anything but a tab was changed.
bool make_ascii(std::string& text);

// Breaks the lines of a keyword's text (separated by '\n') at blanks, the first after at most `first` characters, the
// others after at most `others`; longer words are cut.
std::string in_lines_of(std::string_view text, std::size_t first, std::size_t others);

} // namespace gonio::web_detail
