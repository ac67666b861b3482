// LuminaireFigures: the figures by which a luminaire is planned and judged, each by a named rule.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/figures/figure.hpp>
#include <gonio/figures/luminances.hpp>
#include <gonio/figures/outdoor_classes.hpp>
#include <gonio/figures/ugr_table.hpp>
#include <gonio/figures/utilisation.hpp>
#include <gonio/profile/profile.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/web.hpp>

#include <array>

#pragma GCC visibility push(default)
namespace gonio {

// Shares of the lamps' flux; for absolute photometry, of the luminaire's.
struct OutputRatios {
    double all = 0.0;      // LOR
    double downward = 0.0; // DLOR
    double upward = 0.0;   // ULOR
};

// All figures. Those that the profile does not give have a reason.
struct LuminaireFigures {
    // From the web's C to EULUMDAT's, where C0 looks across the luminaire: C = C_EULUMDAT + this. 0 or −90.
    double crosswise_c_deg = 0.0;

    Figure<UgrTable> ugr;          // spacing 0.25
    Figure<UgrTable> ugr_sh1;      // spacing 1
    Figure<double> ugr_correction; // less this, they are the uncorrected tables of lamps of 1000 lm
    Figure<LuminanceDiagram> luminances;
    Figure<UtilisationCoefficients> coefficients; // IES zonal cavity
    Figure<UtilisationFactors> factors;           // CIE 52
    Figure<std::array<double, 10>> direct_ratios; // shares of the downward flux, at room_indices
    Figure<OutputRatios> output;
    Figure<double> upward_share; // of the luminaire's flux (ULR, R_UL)
    Figure<char> distribution;   // DIN 5040
    Figure<BugRating> bug;
    Figure<CutOff> cut_off_class;
    Figure<int> intensity_class;      // by the luminaire's flux
    Figure<int> intensity_class_lamp; // by the lamps'
    Figure<GlareIndex> glare;
};

// What differs between the makers of tables.
struct FiguresOptions {
    UgrInterpolation ugr_interpolation = UgrInterpolation::intensity;
};

// The figures of a profile and of the web that resolve_web() made of it with the same options. C0 is across the
// luminaire in EULUMDAT and along it in LM-63 and TM-33; an azimuth of the options turns web and opening.
LuminaireFigures luminaire_figures(const Profile& profile, const Web& web, const ResolveOptions& resolve = {},
                                   const FiguresOptions& options = {});

} // namespace gonio
#pragma GCC visibility pop
