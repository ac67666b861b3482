#include "method_list.hpp"

#include <gonio/base/named.hpp>

namespace gonio::cli {

std::string without_aliases(std::string_view list) {
    std::string names;
    for (bool more = true; more;) {
        const std::size_t comma = list.find(',');
        std::string_view name = list.substr(0, comma);
        if (name == "near") name = to_text(IrradianceMethod::exact);
        if (name == "far") name = to_text(IrradianceMethod::point);
        names += name;
        more = comma != std::string_view::npos;
        if (more) names += ',';
        if (more) list.remove_prefix(comma + 1);
    }
    return names;
}

Result<std::vector<IrradianceMethod>> method_list(std::string_view text) {
    auto named = find_all_named("method", without_aliases(text), irradiance_methods());
    if (!named) return pass_on(named);
    std::vector<IrradianceMethod> methods;
    for (const auto* const row : *named)
        methods.push_back(row->method);
    return methods;
}

} // namespace gonio::cli
