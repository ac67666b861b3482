// The distribution of a web's flux: zones of γ, CIE flux codes, the zones of the IES luminaire classification.
//
// Everything is the exact integral of the interpolant for type C and by quadrature for types A and B
// (gonio/web/cone_flux.hpp states the error), γ counted from the nadir and C as in the web.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/profile/profile.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/web.hpp>

#include <array>
#include <optional>

#pragma GCC visibility push(default)
namespace gonio {

// The flux between two γ within [0°, 180°].
Lumens zone_flux(const Web& web, double gamma_low_deg, double gamma_high_deg);

// The eighteen zones of 10°, from the nadir.
std::array<Lumens, 18> ten_degree_zones(const Web& web);

// CIE 52 (EN 13032-2): the flux within the cones of π/2, π and 3π/2 sr about the nadir (γ of 41.4°, 60° and 75.5°) as
// shares of the flux of the lower hemisphere, that flux as a share of the whole (DFF), and the whole as a share of the
// lamps' flux (LOR), which is 1 for absolute photometry. Empty if the divisor is not greater than 0.
struct CieFluxCode {
    std::array<std::optional<double>, 3> within;
    std::optional<double> downward;
    std::optional<double> light_output_ratio;
};

// That of a web; `lamps`: their flux, empty for absolute photometry.
CieFluxCode cie_flux_code(const Web& web, std::optional<Lumens> lamps);

// IES TM-15: luminaire classification system. Front is the half on the side of the plane C `front_c_deg`, a multiple of
// 90°, the street side; back is the other half.
// Secondary solid angles: low 0–30°, medium 30–60°, high 60–80°, very high 80–90°; up 90–100° and 100–180°.
struct LuminaireClassification {
    std::array<Lumens, 4> front;
    std::array<Lumens, 4> back;
    Lumens up_low;
    Lumens up_high;
};

// That of a web, with the street on the side of C `front_c_deg`.
LuminaireClassification luminaire_classification(const Web& web, double front_c_deg = 0.0);

// The C-plane towards the street: C90 in EULUMDAT, where C0 lies along the road (EN 13201); C0 in LM-63, unless the
// light is symmetric about C90–C270 and not about C0–C180, which turns it by a quarter. In the C of the web, which
// resolve_web() may have turned to another convention of azimuths.
double street_side_c_deg(const Profile& profile, const Web& web,
                         AzimuthConvention azimuth = AzimuthConvention::as_written);

} // namespace gonio
#pragma GCC visibility pop
