#include <gonio/web/cone_flux.hpp>
#include <gonio/web/separable.hpp>
#include <gonio/web/symmetry.hpp>
#include <gonio/web/transform.hpp>
#include <gonio/web/zones.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <variant>
#include <vector>

namespace gonio {

namespace {

// Flux between two γ; everything that does not depend on them is computed once.
class ZoneFlux {
public:
    explicit ZoneFlux(const Web& web) : web_(web) {
        if (web.photometry() != Photometry::c)
            cones_.emplace(web);
        else
            planes_ = plane_terms(web, plane_bends_deg(web), 0.0, 360.0);
    }

    Lumens operator()(double gamma_low_deg, double gamma_high_deg) const {
        if (cones_) return Lumens(cones_->zone(gamma_low_deg, gamma_high_deg).both());
        return sum_of(web_, planes_, gamma_terms(web_, gamma_low_deg, gamma_high_deg));
    }

private:
    const Web& web_;
    std::optional<ConeFlux> cones_;
    Terms planes_;
};

} // namespace

Lumens zone_flux(const Web& web, double gamma_low_deg, double gamma_high_deg) {
    return ZoneFlux(web)(gamma_low_deg, gamma_high_deg);
}

std::array<Lumens, 18> ten_degree_zones(const Web& web) {
    std::array<Lumens, 18> zones;
    const ZoneFlux flux_of(web);
    for (std::size_t i = 0; i < zones.size(); ++i)
        zones[i] = flux_of(10.0 * static_cast<double>(i), 10.0 * static_cast<double>(i + 1));
    return zones;
}

CieFluxCode cie_flux_code(const Web& web, std::optional<Lumens> lamps) {
    const auto part = [](Lumens of, Lumens whole) {
        return whole.value > 0.0 ? std::optional(of / whole) : std::nullopt;
    };
    CieFluxCode code;
    const ZoneFlux flux_of(web);
    // The cone of solid angle Ω has cosγ = 1 − Ω/2π.
    std::array<Lumens, 4> up_to;
    Lumens sum;
    double low = 0.0;
    for (std::size_t i = 0; i < up_to.size(); ++i) {
        const double high = i == 3 ? 90.0 : std::acos(0.75 - 0.25 * static_cast<double>(i)) * 180.0 / std::numbers::pi;
        sum = sum + flux_of(low, high);
        up_to[i] = sum;
        low = high;
    }
    for (std::size_t i = 0; i < 3; ++i)
        code.within[i] = part(up_to[i], up_to[3]);
    const Lumens all = up_to[3] + flux_of(90.0, 180.0);
    code.downward = part(up_to[3], all);
    code.light_output_ratio = lamps ? part(all, *lamps) : std::optional(1.0);
    return code;
}

double street_side_c_deg(const Profile& profile, const Web& web, AzimuthConvention azimuth) {
    if (std::holds_alternative<LdtFile>(profile.file)) return azimuth == AzimuthConvention::lm63 ? 0.0 : 90.0;
    const bool turned = azimuth == AzimuthConvention::eulumdat;
    const Symmetry lit_beside = turned ? Symmetry::bilateral_0_180 : Symmetry::bilateral_90_270;
    return (detected_symmetry(web) == lit_beside ? 90.0 : 0.0) + (turned ? 90.0 : 0.0);
}

LuminaireClassification luminaire_classification(const Web& as_is, double front_c_deg) {
    std::optional<Web> turned;
    if (front_c_deg != 0.0) turned = rotated(as_is, -front_c_deg).web;
    const Web& web = turned ? *turned : as_is;
    constexpr std::array limits{0.0, 30.0, 60.0, 80.0, 90.0};
    constexpr std::array edges{0.0, 90.0, 270.0, 360.0};
    LuminaireClassification zones;
    if (web.photometry() != Photometry::c) {
        const ConeFlux cones(web);
        for (std::size_t i = 0; i < 4; ++i) {
            const ConeFlux::Halves lumens = cones.zone(limits[i], limits[i + 1]);
            zones.front[i] = Lumens(lumens.front);
            zones.back[i] = Lumens(lumens.back);
        }
        zones.up_low = Lumens(cones.zone(90.0, 100.0).both());
        zones.up_high = Lumens(cones.zone(100.0, 180.0).both());
        return zones;
    }
    const std::vector<double> bends = plane_bends_deg(web);
    for (std::size_t i = 0; i < 4; ++i) {
        const Terms gammas = gamma_terms(web, limits[i], limits[i + 1]);
        std::array<double, 3> lumens{};
        for (std::size_t k = 0; k < 3; ++k)
            lumens[k] = sum_of(web, plane_terms(web, bends, edges[k], edges[k + 1]), gammas).value;
        zones.front[i] = Lumens(lumens[0] + lumens[2]);
        zones.back[i] = Lumens(lumens[1]);
    }
    zones.up_low = zone_flux(web, 90.0, 100.0);
    zones.up_high = zone_flux(web, 100.0, 180.0);
    return zones;
}

} // namespace gonio
