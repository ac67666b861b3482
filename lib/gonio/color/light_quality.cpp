#include <gonio/base/codes/result.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/color/detail/alpha_opic_of_rays.hpp>
#include <gonio/color/detail/rendering_of_rays.hpp>
#include <gonio/color/light_quality.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gonio {

namespace {

constexpr double hair_nm = 1e-3; // wavelengths of tables are rounded

// The widest step within the range of the sums.
double widest_step_nm(const std::vector<double>& nm) {
    double widest = 0.0;
    for (std::size_t i = 1; i < nm.size(); ++i)
        if (nm[i] > detail::quality_first_nm && nm[i - 1] < detail::quality_last_nm)
            widest = std::fmax(widest, nm[i] - nm[i - 1]);
    return widest;
}

Diagnostics remarks_on(const Spectrum& spectrum) {
    Diagnostics remarks;
    const std::vector<double>& nm = spectrum.wavelengths_nm;
    const bool said = std::any_of(spectrum.diagnostics.begin(), spectrum.diagnostics.end(),
                                  [](const Diagnostic& known) { return known.code == "RES0103"; });
    if (!said && (nm.front() > detail::quality_first_nm + hair_nm || nm.back() < detail::quality_last_nm - hair_nm))
        remarks.push_back(result_diagnostic(
            "RES0103", fmt::format("'{}' reaches from {} to {} nm: taken as 0 beyond, up to 380 and 780 nm",
                                   spectrum.name, rounded(nm.front(), 9), rounded(nm.back(), 9))));
    if (const double widest = widest_step_nm(nm); widest > detail::sample_step_nm + hair_nm)
        remarks.push_back(result_diagnostic(
            "RES0110", fmt::format("'{}' has steps of {} nm, and figures of quality are defined for 5 nm",
                                   spectrum.name, rounded(widest, 4))));
    return remarks;
}

} // namespace

Result<LightQuality> light_quality(const Spectrum& spectrum) {
    Result<detail::Rays> light = detail::rays_of(spectrum);
    if (!light) return pass_on(light);
    LightQuality quality;
    quality.diagnostics = remarks_on(spectrum);
    quality.alpha_opic = detail::alpha_opic_of_rays(*light);
    Result<Cct> cct = detail::reference_temperature(spectrum);
    if (!cct) {
        quality.diagnostics.push_back(
            result_diagnostic("RES0111", fmt::format("no colour rendering of '{}': {}", spectrum.name,
                                                     cct.error().diagnostics.back().message)));
        return quality;
    }
    quality.cct = *cct;
    quality.rendering = detail::rendering_of_rays(*light, cct->temperature);
    quality.fidelity = detail::fidelity_of_rays(*light, cct->temperature);
    if (quality.rendering->reference_duv > greatest_reference_duv)
        quality.diagnostics.push_back(result_diagnostic(
            "RES0109",
            fmt::format(
                "'{}' is {:.4f} in u, v from its reference illuminant: CIE 13.3 accepts 0.0054, so Ra and R1 to R15 "
                "are inaccurate",
                spectrum.name, quality.rendering->reference_duv)));
    return quality;
}

} // namespace gonio
