// Text in HTML. Everything that a report shows of a file, its name included, goes through html().
#pragma once

#include <string>
#include <string_view>

namespace gonio::cli {

// Bytes as the text of an element or of an attribute in double quotes: UTF-8, as to_utf8() has it, with &, <, >, " and
// ' escaped. Control characters other than tab and line end, and marks that reverse the order of what follows them,
// become U+FFFD: a text cannot read as another one.
std::string html(std::string_view bytes);

// As html(), at most `most` bytes of it and "…".
std::string html_start(std::string_view bytes, std::size_t most);

} // namespace gonio::cli
