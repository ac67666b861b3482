#include "method_list.hpp"

#include <algorithm>

namespace gonio::cli {

Result<std::vector<IrradianceMethod>> method_list(std::string_view text) {
    std::vector<IrradianceMethod> methods;
    for (bool more = true; more;) {
        const std::size_t comma = text.find(',');
        Result<IrradianceMethod> parsed = parse_irradiance_method(text.substr(0, comma));
        if (!parsed) return pass_on(parsed);
        if (std::find(methods.begin(), methods.end(), *parsed) == methods.end()) methods.push_back(*parsed);
        more = comma != std::string_view::npos;
        if (more) text.remove_prefix(comma + 1);
    }
    return methods;
}

} // namespace gonio::cli
