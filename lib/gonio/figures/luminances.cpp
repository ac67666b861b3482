#include <gonio/figures/luminances.hpp>
#include <gonio/light/projected_area.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace gonio {

std::array<double, luminance_gammas_deg.size()> LuminanceDiagram::mean_of_planes_nt(int c_deg) const {
    assert(c_deg >= 0 && c_deg < 180 && c_deg % 15 == 0);
    const auto plane = static_cast<std::size_t>(c_deg / 15);
    std::array<double, luminance_gammas_deg.size()> means{};
    for (std::size_t i = 0; i < means.size(); ++i)
        means[i] = 0.5 * (nt[i][plane] + nt[i][plane + luminance_planes / 2]);
    return means;
}

double LuminanceDiagram::greatest_nt(double gamma_deg) const {
    const auto* const found = std::find(luminance_gammas_deg.begin(), luminance_gammas_deg.end(), gamma_deg);
    assert(found != luminance_gammas_deg.end());
    const auto& row = nt.at(static_cast<std::size_t>(found - luminance_gammas_deg.begin()));
    return *std::max_element(row.begin(), row.end());
}

Figure<LuminanceDiagram> luminance_diagram(const Web& web, const Opening& opening) {
    if (opening.shape == OpeningShape::point) return no_figure("the file states no luminous opening");
    LuminanceDiagram diagram;
    for (std::size_t i = 0; i < luminance_gammas_deg.size(); ++i)
        for (std::size_t plane = 0; plane < luminance_planes; ++plane) {
            const double c_deg = 15.0 * static_cast<double>(plane);
            const double gamma_deg = luminance_gammas_deg[i];
            const double intensity_cd = std::max(web.candela(c_deg, gamma_deg), 0.0);
            if (intensity_cd == 0.0) continue;
            const double area_m2 = projected_area_m2(opening, direction_of({degrees(c_deg), degrees(gamma_deg)}));
            if (!(area_m2 > 0.0))
                return no_figure(fmt::format("the luminous opening has no area towards C {}°, gamma {}°, where the "
                                             "luminaire shines",
                                             c_deg, gamma_deg));
            diagram.nt[i][plane] = intensity_cd / area_m2;
        }
    return diagram;
}

} // namespace gonio
