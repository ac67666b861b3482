// ProfileFacts: what `gonio info` says about a profile: its format and grid, the lamps that it declares, and the
// figures of its web. Angles in degrees, lengths in metres, power in watts.
//
// Intensities are candela and fluxes lumens, unless the file states another unit and the options do not take its
// numbers as candela: then all of them, under the same names, are in intensity_unit and flux_unit.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/profile/luminous_opening.hpp>
#include <gonio/profile/profile.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/spacing.hpp>
#include <gonio/web/web.hpp>
#include <gonio/web/zones.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// Lamps as a file declares them: a lamp set of EULUMDAT, an emitter of TM-33, all of LM-63. Texts are UTF-8.
struct DeclaredLamps {
    int count = 1;
    std::string type;
    std::optional<double> flux_lm; // of all of them
    std::optional<double> cct_k;
    std::string cri; // as written; EULUMDAT has groups like "1A"
    std::optional<double> input_w;
};

// What there is to say about a profile.
struct ProfileFacts {
    std::string intensity_unit = "cd"; // "mW/sr"
    std::string flux_unit = "lm";
    std::string format; // "IES", "LDT", "TM-33"
    std::string version;
    char photometry = 'C';
    std::size_t planes = 0; // as stored
    std::size_t gammas = 0;
    Symmetry symmetry = Symmetry::none; // of the numbers
    Symmetry declared_symmetry = Symmetry::none;
    std::vector<DeclaredLamps> lamps;
    double flux_lm = 0.0;
    double zonal_flux_lm = 0.0;
    std::optional<double> declared_flux_lm; // empty for absolute photometry
    Peak peak;
    std::optional<double> beam_deg; // in C0–C180
    std::optional<double> field_deg;
    std::optional<double> beam_c90_deg; // in C90–C270
    std::optional<double> field_c90_deg;
    std::optional<double> input_w;
    LuminousOpening opening;
    std::optional<double> point_distance_m;     // from which on a point is within 1 %; empty for a point; not if brief
    std::optional<int> nema_horizontal;         // by the field angle in C0–C180
    std::optional<int> nema_vertical;           // in C90–C270
    std::array<Lumens, 18> ten_degree_zones_lm; // from the nadir

    // Only for FactsExtent::all.
    Candelas center_beam;
    std::optional<double> cie_beam_deg;
    std::optional<double> cie_beam_c90_deg;
    CieFluxCode cie_code;
    SpacingCriterion spacing;
    double street_side_c_deg = 0.0; // what front is in the next one
    LuminaireClassification classes;

    // The flux between two γ, both multiples of 10 from 0 to 180.
    double zone_lm(std::size_t low_deg, std::size_t high_deg) const;

    // Empty without watts and for units other than lumens.
    std::optional<double> efficacy_lm_per_w() const;
};

// How much profile_facts() works out.
enum class FactsExtent {
    brief,  // neither the distance from which a luminaire is a point, nor what `all` adds
    report, // that distance too: as long as the rest together, for a profile with an opening
    all     // and what costs more than the rest together on a fine table
};

// The facts of a profile and of the web that resolve_web() made of it with the same options.
ProfileFacts profile_facts(const Profile& profile, const Web& web, const ResolveOptions& options = {},
                           FactsExtent extent = FactsExtent::all);

} // namespace gonio
#pragma GCC visibility pop
