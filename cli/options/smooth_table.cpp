#include "smooth_table.hpp"

#include <gonio/base/codes/result.hpp>
#include <gonio/base/quantity.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/smooth.hpp>

#include <fmt/format.h>

namespace gonio::cli {

Result<std::optional<double>> smooth_step(const Arguments& arguments) {
    const auto text = arguments.value("--smooth");
    if (!text) return std::optional<double>();
    Result<double> step = parse_amount(*text, Dimension::angle, "--smooth");
    if (!step) return pass_on(step);
    return std::optional<double>(to_degrees(Radians(*step)));
}

Result<Web> smooth_table(const Web& web, double step_deg, const std::string& file, Diagnostics& diagnostics) {
    Result<Web> smooth = smoothed(web, step_deg);
    if (!smooth) return smooth;
    diagnostics.push_back(result_diagnostic(
        "RES0208",
        fmt::format("a smooth curve through {} by {} angles: {:.6g} lm instead of {:.6g} lm",
                    web.horizontal_deg().size(), web.vertical_deg().size(), flux(*smooth).value, flux(web).value),
        {}, file));
    return smooth;
}

} // namespace gonio::cli
