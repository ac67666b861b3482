// Texts as the portable dialect writes them: ASCII, in lines that every reader takes whole. Internal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gonio::web_detail {

// UTF-8, or the code page 1252 where the bytes are no UTF-8: letters lose their accents, units are spelt, all else
// becomes '?'; tabs become blanks. Whether anything but a tab was changed.
bool make_ascii(std::string& text);

// Breaks the lines of a keyword's text (separated by '\n') at blanks, the first after `first` characters, the others
// after `others`; words longer than that are cut.
std::string in_lines_of(std::string_view text, std::size_t first, std::size_t others);

} // namespace gonio::web_detail
