#include <gonio/figures/web_means.hpp>
#include <gonio/web/separable.hpp>
#include <gonio/web/symmetry.hpp>

#include <cstddef>
#include <numbers>

namespace gonio {

MeanIntensity::MeanIntensity(const Web& web) : web_(web) {
    if (web.photometry() == Photometry::c) {
        for (const Term& term : plane_terms(web, plane_bends_deg(web), 0.0, 360.0)) {
            c_deg_.push_back(web.planes_deg()[term.index]);
            weight_.push_back(term.weight / (2.0 * std::numbers::pi));
        }
        return;
    }
    constexpr int count = 720;
    for (int i = 0; i < count; ++i)
        c_deg_.push_back((i + 0.5) * 360.0 / count);
    weight_.assign(count, 1.0 / count);
}

double MeanIntensity::candela(double gamma_deg) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < c_deg_.size(); ++i)
        sum += weight_[i] * web_.candela(c_deg_[i], gamma_deg);
    return sum;
}

} // namespace gonio
