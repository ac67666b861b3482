// JSON reports: key order as written, numbers that read back as the same doubles.
#pragma once

#include <gonio/base/diagnostics.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>
#include <string>

namespace gonio::cli {

using Json = nlohmann::ordered_json;

// The number, or null if there is none or it is not finite: JSON has no such numbers.
inline Json number_or_null(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

inline Json diagnostics_json(const Diagnostics& diagnostics) {
    Json list = Json::array();
    for (const Diagnostic& diagnostic : diagnostics)
        list.push_back({{"code", diagnostic.code},
                        {"severity", to_text(diagnostic.severity)},
                        {"file", diagnostic.location.file},
                        {"line", diagnostic.location.line},
                        {"column", diagnostic.location.column},
                        {"message", diagnostic.message},
                        {"hint", diagnostic.hint}});
    return list;
}

// Text from a file need not be UTF-8: invalid bytes become replacement characters instead of a failure.
inline std::string dump(const Json& json, int indent) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace gonio::cli
