#include <gonio/asset/detail/same_flux.hpp>
#include <gonio/light/closed_forms.hpp>
#include <gonio/web/zones.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::asset_detail {

namespace {

using std::numbers::pi;

// Whether the light reaches a thousandth of its peak above the horizon.
bool shines_up(const Web& web, Candelas peak) {
    for (std::size_t plane = 0; plane < web.planes_deg().size(); ++plane)
        for (std::size_t k = 0; k < web.gammas_deg().size(); ++k)
            if (web.gammas_deg()[k] > 90.001 && web.column(plane)[k] > 1e-3 * peak.value) return true;
    return false;
}

// Flux-weighted mean of cosγ below the horizon, from the exact flux of rings of 5°.
double mean_cosine(const Web& web) {
    constexpr double step_deg = 5.0;
    double lumens = 0.0;
    double weighted = 0.0;
    for (int i = 0; i < 18; ++i) {
        const double low = step_deg * i;
        const double high = low + step_deg;
        const double ring = zone_flux(web, low, high).value;
        lumens += ring;
        weighted += ring * 0.5 * (std::cos(low * pi / 180.0) + std::cos(high * pi / 180.0));
    }
    return lumens > 0.0 ? weighted / lumens : 0.0;
}

struct Cone {
    double inner, outer; // half angles [rad]
};

// The cone for which glTF's lobe ((cosθ − cos outer)/(cos inner − cos outer))² is as narrow, that is, has the same mean
// cosine. Without an inner cone the mean cosine is (3 + cos outer)/4; wider lobes end at the horizon and have an inner
// cone.
Cone cone_of(double mean_cosine) {
    if (mean_cosine >= 0.75) return {0.0, std::acos(std::clamp(4.0 * mean_cosine - 3.0, 0.0, 1.0))};
    // The mean cosine for an inner cosine c, (½ − ¼c²)/(1 − ⅔c), rises from ½ to ¾.
    double low = 0.0;
    double high = 1.0;
    for (int step = 0; step < 60; ++step) {
        const double c = 0.5 * (low + high);
        (((0.5 - 0.25 * c * c) / (1.0 - 2.0 / 3.0 * c) < mean_cosine) ? low : high) = c;
    }
    return {std::acos(low), 0.5 * pi};
}

SameFlux spot_of(double lumens, double mean_cosine) {
    const auto [inner, outer] = cone_of(mean_cosine);
    const double widest_inner = std::min(inner, 0.999 * outer); // below the outer angle, as glTF requires
    return {false, lumens / closed_form::spot_solid_angle(Falloff::frostbite, widest_inner, outer), widest_inner,
            outer};
}

} // namespace

SameFlux same_flux(const MeasuredLight& light) {
    if (shines_up(light.web, light.peak)) return {true, light.flux.value / (4.0 * pi), 0.0, 0.0};
    return spot_of(light.flux.value, mean_cosine(light.web));
}

SameFlux same_flux_as_area(double candela) {
    return spot_of(pi * candela, 2.0 / 3.0); // I cosθ
}

} // namespace gonio::asset_detail
