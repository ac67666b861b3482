// MeasuredLight: a luminaire in the form that engines get, resolved once for every target.
//
// A profile can describe the same light in many ways, of which engines read few, so all of them get one form: the
// portable dialect of LM-63 (gonio/web/to_profile.hpp), with ballast factor, multiplier, TILT, the requested flux and
// the rotation about the axis already applied to the numbers of the table. The web here is read from those same bytes,
// so that what is measured on it is what is delivered.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/color/spectrum.hpp>
#include <gonio/web/profile_header.hpp>
#include <gonio/web/web.hpp>

#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// A measured luminaire as targets get it.
struct MeasuredLight {
    std::string name;          // of files and nodes: letters, digits, '_' and '-'
    std::string portable_ies;  // the bytes
    Web web;                   // of these bytes; type C
    Lumens flux;               // its integral
    Candelas peak;             // its greatest intensity
    glm::dvec3 color{1.0};     // linear Rec.709 of luminance 1
    std::string color_text;    // origin of the colour: "2700K", "spectrum"; empty where nothing is known
    std::string source_file;   // as the user named it
    std::string source_sha256; // of its bytes
    ProfileHeader header;      // of the source
    Candelas max_error;        // greatest |delivered − wanted| intensity
};

// A profile to deliver.
struct MeasuredLightSource {
    std::string file;       // as the user named it
    std::string_view bytes; // of the file
    const Web& web;
    const ProfileHeader& header;
    std::span<const Spectrum> spectra = {}; // of the file
};

// What measured_light() changes of a profile.
struct MeasuredLightOptions {
    std::optional<Lumens> flux; // the flux to scale to; without it, as measured
    Radians rotation;           // about the axis, C0 towards C90
    std::string color;          // as parse_light_color takes it; empty: that of the file's spectrum, else of its
                                // colour temperature, else white
};

// Fails as rotated(), scaled_to() and parse_light_color() do, and (unsupported) on a web without light, which no engine
// can scale. Diagnostics: anything that the portable dialect cannot store, and a colour temperature that cannot be
// parsed.
Result<MeasuredLight> measured_light(const MeasuredLightSource& source, const MeasuredLightOptions& options,
                                     Diagnostics& diagnostics);

// The name of an asset made from a file: the file's name without folder and ending; every character that some file
// system, shell or scene language does not accept is replaced by '_'.
std::string asset_name(std::string_view file);

// The colour temperature [K] in a profile's text: "3000", "3000 K", "4000K warm white", or a lamp's code "830" (colour
// rendering from 80, 3000 K). Nothing for other texts.
std::optional<double> color_temperature_of(std::string_view text);

} // namespace gonio
#pragma GCC visibility pop
