// Profile → Web: the meaning of a file, decided once.
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

// The origin of C. LM-63 puts C0 along a luminaire's length and EULUMDAT across it, so a file of one
// convention is rotated by 90° in the other.
enum class AzimuthConvention {
    as_written, // every file's own: C is what it lists
    lm63,       // EULUMDAT files are rotated by −90°
    eulumdat    // IES files are rotated by 90°: their C0 becomes C90
};

struct ResolveOptions {
    int lamp_set = 1;      // EULUMDAT: which of the alternative lamp sets, from 1
    double tilt_deg = 0.0; // IES with TILT=INCLUDE: the mounting tilt whose factor applies
    AzimuthConvention azimuth = AzimuthConvention::as_written;

    friend bool operator==(const ResolveOptions&, const ResolveOptions&) = default;
};

// A web and its diagnostics (the caller appends them to those of the profile).
struct ResolvedWeb {
    Web web;
    Diagnostics diagnostics;
};

// Fails: malformed where the angles make no web or an intensity is above greatest_amount (WEB0108), usage on a lamp set
// that the file does not have.
Result<ResolvedWeb> resolve_web(const Profile& profile, const ResolveOptions& options = {});

// The same if the profile is no longer needed: the web takes over its table, so that there are never two. What
// is left of the profile has no table.
Result<ResolvedWeb> resolve_web(Profile&& profile, const ResolveOptions& options = {});

// Lumens of the lamps as the file declares them; nothing for absolute photometry.
std::optional<double> declared_flux_lm(const Profile& profile, const ResolveOptions& options = {});

} // namespace gonio
