// The line of a file that a diagnostic is about, with a caret below the column.
#pragma once

#include <gonio/base/diagnostics.hpp>

#include <string>
#include <string_view>

namespace gonio::cli {

// A <pre> element:
//
//   18 | 3535.8 3530.1 35x4.2
//      |               ^
//
// Lines and columns count as those of the readers of profiles do: a line ends with CR LF, LF or CR, a column is a byte.
// A long line is cut around the column. Empty if the location has no line, or the text has fewer lines.
std::string excerpt(std::string_view bytes, const Location& location);

} // namespace gonio::cli
