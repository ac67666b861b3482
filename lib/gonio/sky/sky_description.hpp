// Skies as text: what a rig or a command line states about the light from all around.
//
//   500lx, 150nt                               uniform, in short
//   uniform:horizontal=500lx,color=6500K
//   cie:12,sun=180/40,horizontal=20klx         one of the CIE's general skies, under a sun by azimuth/elevation [°]
//   daylight:place=52.52/13.405,time=2024-06-21T12:00+02:00,weather=clear
//   image:room.exr,horizontal=500lx            a picture of the light from all around
//
// The text has the form of shapes and materials, KIND:key=value,… (base/kind_text.hpp). Nothing is opened here.
// sky_kinds() describes each kind once: its name, its keys and how they are read.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/sky/cie_sky.hpp>
#include <gonio/sky/daylight_availability.hpp>
#include <gonio/sky/environment_map.hpp>
#include <gonio/sky/solar_position.hpp>

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#pragma GCC visibility push(default)
namespace gonio {

class FileScope;

// The same luminance from every direction, also from below.
struct UniformSkyKind {};

// One of the sixteen skies of the CIE, and the sun's position.
struct CieSkyKind {
    const CieSkyType* type = nullptr;
    SkyAngles sun{0.0, 90.0}; // where the luminance depends on it
};

// A CIE sky and the sun, with the amounts of daylight_availability.hpp.
struct DaylightSkyKind {
    Place place;
    Instant time;
    Weather weather = Weather::clear;
    bool refraction = false;   // the sun as seen through standard air, not geometric
    glm::dvec3 sun_color{1.0}; // linear Rec.709 of luminance 1
};

// A file, which is not opened here: the program that resolves the sky reads it (media/environment_file.hpp).
struct ImageSkyKind {
    std::string file;
    std::optional<EnvironmentLayout> layout; // nothing: by the ratio of its sides
    std::string space;                       // colour space of its pixels; empty: linear Rec.709
    BadPixels bad_pixels = BadPixels::error;
};

// In the order in which they are listed.
using SkyKind = std::variant<UniformSkyKind, CieSkyKind, DaylightSkyKind, ImageSkyKind>;

// What an amount is measured on.
enum class SkyMeasure : std::uint8_t {
    horizontal, // illuminance of an open horizontal plane that faces up [lx], without the sun
    zenith,     // luminance of the zenith [cd/m²]
    mean        // luminance, mean over the solid angle of the sky: the upper hemisphere, of uniform ones and images the
                // sphere
};

// How much light, and of which measure.
struct SkyAmount {
    SkyMeasure measure = SkyMeasure::horizontal;
    double value = 0.0; // [lx] or [cd/m²], ≥ 0
};

// What a rig or a command line specifies for a sky.
struct SkyDescription {
    SkyKind kind;
    std::optional<SkyAmount> amount; // present unless the kind has an amount of its own
    glm::dvec3 color{1.0};           // linear Rec.709 of luminance 1
    Radians rotation;                // about the vertical: azimuths grow by it
    double ground = 0.0;             // albedo of a matte plane below: its luminance shows below the horizon
};

// A kind of sky by its name, as `gonio list skies` shows it.
struct SkyKindInfo {
    std::string_view name;
    std::string_view grammar;
    std::string_view summary;
};

// All of them.
std::span<const SkyKindInfo> sky_kinds();

// Its name in the grammar.
std::string_view name_of(const SkyKind& kind);

// The name of a file at the beginning of a text with keys, "room.exr,rotate=30deg": it ends before the first comma that
// "word=" follows, and may contain other commas.
std::string_view file_before_keys(std::string_view text);

// The short form alone: "500lx" on an open plane, or "150nt". Fails (usage) on other units, and on less than 0.
Result<Nits> parse_uniform_sky(std::string_view text);

// Remarks are appended to `diagnostics` if it is given. An image and the spectrum of a colour may be any file or, if
// `files` is given, one that `files` allows; the name of an image is that of file_before_keys(). Fails
// (usage) on unknown kinds and keys, on values out of their ranges, on an amount that is missing or given twice, and on
// a sun below the horizon.
Result<SkyDescription> parse_sky_description(std::string_view text, Diagnostics* diagnostics = nullptr,
                                             FileScope* files = nullptr);

} // namespace gonio
#pragma GCC visibility pop
