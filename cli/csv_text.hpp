// Fields of comma-separated output.
#pragma once

#include <string>
#include <string_view>

namespace gonio::cli {

// Quoted if a comma or a quote would break the row (RFC 4180).
inline std::string csv_field(std::string_view text) {
    if (text.find_first_of(",\"\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

} // namespace gonio::cli
