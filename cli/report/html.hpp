// Text in HTML. Everything that a report shows of a file, its name included, goes through html().
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gonio::cli {

// Bytes as text that shows what it is: UTF-8, as to_utf8() has it. Control characters other than tab and line end, and
// marks that reverse the order of what follows them, become U+FFFD: a text cannot read as another one.
std::string plain_text(std::string_view bytes);

// plain_text() for an element, or for an attribute in double quotes: &, <, >, " and ' are escaped.
std::string html(std::string_view bytes);

// As html(), at most `most` bytes of it and "…".
std::string html_start(std::string_view bytes, std::size_t most);

} // namespace gonio::cli
