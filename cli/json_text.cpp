#include "json_text.hpp"

namespace gonio::cli {

Json number_or_null(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

Json diagnostics_json(const Diagnostics& diagnostics) {
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

std::string dump(const Json& json, int indent) {
    return json.dump(indent) + "\n";
}

} // namespace gonio::cli
