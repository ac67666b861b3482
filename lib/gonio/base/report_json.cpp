#include <gonio/base/report_json.hpp>

namespace gonio::detail {

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

} // namespace gonio::detail
