// Profile → Web: what the file means, decided once.
//
// Applied: candela multiplier, ballast factor, the 12th field where its edition makes it a factor (1986, 1991), TILT at
// the asked mounting tilt, EULUMDAT's cd/klm × flux of the lamp set × conversion factor. Symmetry is read from the
// angles (IES) or Isym (EULUMDAT) and kept; types A and B keep their own grid, an H or V that starts at 0 standing for
// both sides. A missing 360° plane is closed when the gap is one step.
#pragma once

#include <gonio/profile/profile.hpp>
#include <gonio/web/web.hpp>

#include <optional>

namespace gonio {

// From where C counts. LM-63 puts C0 along a luminaire's length and EULUMDAT across it, so that a file of the one
// tradition is turned by 90° in the other's terms.
enum class AzimuthConvention {
    as_written, // every file's own: C is what it lists
    lm63,       // EULUMDAT files are turned by −90°
    eulumdat    // IES files are turned by 90°: their C0 is C90 then
};

struct ResolveOptions {
    int lamp_set = 1;      // EULUMDAT: which of the alternative lamp sets, from 1
    double tilt_deg = 0.0; // IES with TILT=INCLUDE: the mounting tilt whose factor applies
    AzimuthConvention azimuth = AzimuthConvention::as_written;

    friend bool operator==(const ResolveOptions&, const ResolveOptions&) = default;
};

// A web, and what was noticed on the way (appended to the profile's own diagnostics by the caller).
struct ResolvedWeb {
    Web web;
    Diagnostics diagnostics;
};

// Fails: malformed where the angles make no web or an intensity is above greatest_amount (WEB0108), usage on a lamp set
// that the file does not have.
Result<ResolvedWeb> resolve_web(const Profile& profile, const ResolveOptions& options = {});

// The same where the profile is not needed any more: the web takes its table over, so that there never are two. What
// is left of the profile has no table.
Result<ResolvedWeb> resolve_web(Profile&& profile, const ResolveOptions& options = {});

// Lumens of the lamps as the file declares them; nothing for absolute photometry, where there is no such number.
std::optional<double> declared_flux_lm(const Profile& profile, const ResolveOptions& options = {});

} // namespace gonio
