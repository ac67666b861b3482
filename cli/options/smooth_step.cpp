#include "smooth_step.hpp"

#include <gonio/base/quantity.hpp>
#include <gonio/base/unit_text.hpp>

namespace gonio::cli {

Result<std::optional<double>> smooth_step(const Arguments& arguments) {
    const auto text = arguments.value("--smooth");
    if (!text) return std::optional<double>();
    Result<double> step = parse_amount(*text, Dimension::angle, "--smooth");
    if (!step) return pass_on(step);
    return std::optional<double>(to_degrees(Radians(*step)));
}

} // namespace gonio::cli
