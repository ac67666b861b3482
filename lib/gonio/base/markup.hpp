// What text needs inside XML and HTML. Internal.
#pragma once

#include <string_view>

namespace gonio {

// The entity for a character that text or a quoted attribute may not hold; empty: the character itself.
constexpr std::string_view markup_entity(char c) {
    switch (c) {
    case '&':
        return "&amp;";
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '"':
        return "&quot;";
    default:
        return {};
    }
}

} // namespace gonio
