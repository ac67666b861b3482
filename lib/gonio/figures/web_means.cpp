#include <gonio/figures/web_means.hpp>
#include <gonio/web/separable.hpp>
#include <gonio/web/symmetry.hpp>
#include <gonio/web/web_rows.hpp>

#include <cstddef>
#include <numbers>

namespace gonio {

std::vector<double> mean_candela(const Web& web, std::span<const double> gammas_deg) {
    std::vector<double> means(gammas_deg.size());
    web_detail::WebRows rows(web, gammas_deg);
    const auto add = [&](double weight, double c_deg) {
        const std::span<const double> row = rows.quick(c_deg);
        for (std::size_t j = 0; j < means.size(); ++j)
            means[j] += weight * row[j];
    };
    if (web.photometry() == Photometry::c) {
        for (const Term& term : plane_terms(web, plane_bends_deg(web), 0.0, 360.0))
            add(term.weight / (2.0 * std::numbers::pi), web.planes_deg()[term.index]);
        return means;
    }
    constexpr int count = 720;
    for (int i = 0; i < count; ++i)
        add(1.0 / count, (i + 0.5) * 360.0 / count);
    return means;
}

} // namespace gonio
