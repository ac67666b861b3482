#include <gonio/base/named.hpp>
#include <gonio/color/alpha_opic.hpp>
#include <gonio/color/detail/alpha_opic_of_rays.hpp>
#include <gonio/color/detail/quality_tables.hpp>
#include <gonio/color/detail/spectrum_samples.hpp>
#include <gonio/color/luminous_efficacy.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace gonio {

namespace {

constexpr std::array receptors{ReceptorName{"s_cone", "S cone", Receptor::s_cone, 0.8173},
                               ReceptorName{"m_cone", "M cone", Receptor::m_cone, 1.4558},
                               ReceptorName{"l_cone", "L cone", Receptor::l_cone, 1.6289},
                               ReceptorName{"rhodopic", "rods", Receptor::rhodopic, 1.4497},
                               ReceptorName{"melanopic", "melanopsin", Receptor::melanopic, 1.3262}};
static_assert(receptors.size() == receptor_count &&
              in_enum_order(receptors, &ReceptorName::receptor, Receptor::melanopic));

} // namespace

std::span<const ReceptorName> receptor_names() {
    return receptors;
}

AlphaOpic detail::alpha_opic_of_rays(const Rays& light) {
    std::array<double, receptor_count> sum{};
    double luminous = 0.0;
    for (std::size_t i = 0; i < light.nm.size(); ++i) {
        const auto last = static_cast<double>(alpha_opic_spectra.size() - 1);
        const double place = std::clamp(light.nm[i] - quality_first_nm, 0.0, last);
        const auto row = std::min(static_cast<std::size_t>(place), alpha_opic_spectra.size() - 2);
        const double f = place - static_cast<double>(row);
        for (std::size_t r = 0; r < receptor_count; ++r) {
            const double low = alpha_opic_spectra[row][r];
            sum[r] += light.power[i] * (low + f * (alpha_opic_spectra[row + 1][r] - low));
        }
        luminous += light.power[i] * observer_at(light.nm[i]).y;
    }
    AlphaOpic result;
    for (std::size_t r = 0; r < receptor_count; ++r) {
        result.efficacy_mw_per_lm[r] = 1e3 * sum[r] / (luminous_efficacy_constant * luminous);
        result.der[r] = result.efficacy_mw_per_lm[r] / receptors[r].d65_mw_per_lm;
    }
    return result;
}

Result<AlphaOpic> alpha_opic(const Spectrum& spectrum) {
    Result<detail::Rays> light = detail::rays_of(spectrum);
    if (!light) return pass_on(light);
    return detail::alpha_opic_of_rays(*light);
}

} // namespace gonio
