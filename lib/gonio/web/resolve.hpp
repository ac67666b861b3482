// Profile → Web: the meaning of a file, decided once.
//
// Applied: candela multiplier, ballast factor, the 12th field if it is a factor in its edition (1986, 1991), TILT at
// the requested mounting tilt, EULUMDAT's cd/klm × flux of the lamp set × conversion factor. Symmetry is read from the
// angles (IES) or Isym (EULUMDAT) and kept; types A and B keep their own grid, and an H or V that starts at 0
// represents both sides. A missing 360° plane is closed if the gap is one step.
#pragma once

#include <gonio/profile/profile.hpp>
#include <gonio/web/web.hpp>

#include <optional>

#pragma GCC visibility push(default)
namespace gonio {

// The origin of C. LM-63 puts C0 along a luminaire's length and EULUMDAT across it, so a file of one convention is
// rotated by 90° in the other.
enum class AzimuthConvention {
    as_written, // as in each file: C is what it lists
    lm63,       // EULUMDAT files are rotated by −90°
    eulumdat    // IES files are rotated by 90°: their C0 becomes C90
};

// What a file leaves open: which lamp set, which tilt, which convention.
struct ResolveOptions {
    int lamp_set = 1;      // EULUMDAT: which of the alternative lamp sets, from 1
    double tilt_deg = 0.0; // IES with TILT=INCLUDE: the mounting tilt, which selects the factor
    AzimuthConvention azimuth = AzimuthConvention::as_written;
    bool as_candela = false; // no warning (WEB0110) if the file states other units (gonio/web/radiometric.hpp)

    friend bool operator==(const ResolveOptions&, const ResolveOptions&) = default;
};

// A web and its diagnostics (the caller appends them to those of the profile).
struct ResolvedWeb {
    Web web;
    Diagnostics diagnostics;
};

// Fails: malformed if the angles do not form a web or an intensity is above greatest_amount (WEB0108); usage on a lamp
// set that the file does not have.
Result<ResolvedWeb> resolve_web(const Profile& profile, const ResolveOptions& options = {});

// The same if the profile is no longer needed: the web takes over its table, so that there is never a second copy. The
// remaining profile has no table.
Result<ResolvedWeb> resolve_web(Profile&& profile, const ResolveOptions& options = {});

// Lumens of the lamps as declared in the file; empty for absolute photometry.
std::optional<double> declared_flux_lm(const Profile& profile, const ResolveOptions& options = {});

} // namespace gonio
#pragma GCC visibility pop
