// Web + header → Profile: the reverse direction, to any format and dialect.
//
// The resulting file describes the same web: when resolved again, it agrees with the original to 1e-6 of the peak or
// better (numbers are written exactly; scaling to cd/klm rounds once). Anything that the target cannot store is
// reported in the diagnostics: codes WEB02… of gonio/base/codes/web.hpp. Azimuths are kept; the 90° between the
// conventions of LM-63 and EULUMDAT are not applied here, but noted (WEB0220).
//
// Tables are written as readers expect them. Vertical angles begin at 0 or 90 and end at 90 or 180 degrees, padded with
// zeros if the web's table ends elsewhere. LM-63 without symmetry has planes from 0 to 360, both included; symmetric
// planes are kept, except that planes from 90 to 270 are kept only in LM-63-1995. EULUMDAT lists its planes over 0 to
// 360 without the last and stores those that Isym requires. TM-33 has the tables of LM-63-1995.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/profile/profile.hpp>
#include <gonio/web/profile_header.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/web.hpp>

#include <optional>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// The format and dialect to write.
enum class ProfileTarget {
    lm63, // the edition of the source if it has one, else 2002
    lm63_1995,
    lm63_2002,
    lm63_2019,
    portable, // LM-63-2002 as all common loaders read it
    eulumdat,
    tm33 // ANSI/IES TM-33-23
};

const char* to_text(ProfileTarget target); // "ies", "lm-63-2002", "portable", "ldt", "tm33"

// Empty for any other name.
std::optional<ProfileTarget> find_profile_target(std::string_view name);

// A file made from a web, or from another file, and everything lost in the process.
struct MadeProfile {
    Profile profile; // its `diagnostics` member is empty
    Diagnostics diagnostics;
};

// Works for any web and header. The portable dialect is LM-63-2002 with one lamp, multiplier, ballast factor and
// twelfth field 1, TILT=NONE, the table's flux as the lamps' lumens, metres, ASCII, planes over the full turn or a
// single one at 0, and values of at most nine digits. A web of type A or B keeps its coordinates in LM-63, and is
// resampled to type C for the portable dialect and EULUMDAT, with the error reported. Fails (malformed) if a number of
// the file would be above greatest_amount: lumens or watts of the header, or intensities per 1000 lm of lumens close to
// 0.
Result<MadeProfile> to_profile(const Web& web, const ProfileHeader& header, ProfileTarget target);

// Converts a file to another. Within the same format and edition it is kept field by field. To another edition of
// LM-63, and from LM-63 to TM-33, the multiplier, the ballast factor and TILT stay factors. Otherwise it is resolved
// with `options` and made anew; `options` other than the default always make it anew.
Result<MadeProfile> convert_profile(const Profile& profile, ProfileTarget target, const ResolveOptions& options = {});

// As convert_profile, but a table that has a higher symmetry than its stored one, to within `tolerance` of its peak, is
// made anew under that symmetry (gonio/web/symmetry.hpp), which is reported. Other tables are converted as above.
Result<MadeProfile> convert_compacted(const Profile& profile, ProfileTarget target, double tolerance,
                                      const ResolveOptions& options = {});

// The target that corresponds to a file: its format, and its edition if there is a dialect of that name.
std::optional<ProfileTarget> target_of(const Profile& profile);

// The error of a written web against its source, at all angles of both tables, where the difference of two interpolants
// is greatest. The 0.0001° beside a dark range are excluded. Webs of different goniometer types are compared by
// gonio/web/compare.hpp.
struct ConversionError {
    Candelas max;
    double relative = 0.0; // to the source's peak; 0 if the source is dark
    double c_deg = 0.0;
    double gamma_deg = 0.0;
};

// The error of `made` against `source`.
ConversionError conversion_error(const Web& source, const Web& made);

// The bytes of a profile; in the portable dialect no line exceeds 132 characters, including the line end.
std::string write_profile(const Profile& profile, ProfileTarget target);

} // namespace gonio
#pragma GCC visibility pop
