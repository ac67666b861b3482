// Diagnostics in a report: code, message, hint, the line of the file, and what `gonio explain` says of the code.
#pragma once

#include <gonio/base/diagnostics.hpp>

#include <string>
#include <string_view>

namespace gonio::cli {

// A list; a sentence if there are none. `bytes` are those of `file`: a diagnostic of another file shows no line.
std::string diagnostics_list(const Diagnostics& diagnostics, const std::string& file, std::string_view bytes);

// "1 error, 2 warnings"; empty for none.
std::string diagnostics_count(const Diagnostics& diagnostics);

} // namespace gonio::cli
