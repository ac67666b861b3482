#include <gonio/bake/latlong.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/symmetry.hpp>

#include <cstddef>
#include <numbers>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr double radians_per_degree = pi / 180.0;

} // namespace

LatlongMeans::LatlongMeans(const Web& web, int width) : web_(web), columns_(static_cast<std::size_t>(width)) {
    const std::vector<double> bends = plane_bends_deg(web);
    for (int i = 0; i < width; ++i) {
        Terms& terms = columns_[static_cast<std::size_t>(i)];
        terms =
            plane_terms(web, bends, static_cast<double>(i) / width * 360.0, static_cast<double>(i + 1) / width * 360.0);
        for (Term& term : terms)
            term.weight *= width / (2.0 * pi);
    }
}

void LatlongMeans::row(double low_deg, double high_deg, std::span<double> out) const {
    const Terms gammas = gamma_terms(web_, low_deg, high_deg);
    const double measure = integrate_linear_sin(low_deg * radians_per_degree, high_deg * radians_per_degree, 1.0, 1.0);
    std::vector<double> plane_means(web_.planes_deg().size(), 0.0);
    for (std::size_t p = 0; p < plane_means.size(); ++p)
        for (const Term& term : gammas)
            plane_means[p] += term.weight / measure * web_.column(p)[term.index];
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i] = 0.0;
        for (const Term& term : columns_[i])
            out[i] += term.weight * plane_means[term.index];
    }
}

} // namespace gonio
