#include "method_list.hpp"

#include <gonio/base/named.hpp>

namespace gonio::cli {

Result<std::vector<IrradianceMethod>> method_list(std::string_view text) {
    auto named = find_all_named("method", text, irradiance_methods());
    if (!named) return pass_on(named);
    std::vector<IrradianceMethod> methods;
    for (const auto* const row : *named)
        methods.push_back(row->method);
    return methods;
}

} // namespace gonio::cli
