#pragma once

#include <gonio/base/diagnostics.hpp>

#include <string>

namespace gonio::test {

// Everything that was reported, with its place.
inline std::string said(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics)
        text += to_text(diagnostic) + '\n';
    return text.empty() ? "(nothing)\n" : text;
}

} // namespace gonio::test
