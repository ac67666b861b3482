// Linear RGB spaces, and colours of lights in them.
//
// XYZ is always relative to a D65 white of xy 0.3127, 0.3290. Spaces with another white (the ACES spaces) are converted
// with Bradford's adaptation, as in OpenColorIO's own transforms, so that D65 is neutral in each: (1, 1, 1). The
// luminance of an RGB is the middle row of the space's whole matrix RGB → XYZ. Bradford changes Y of a colour that is
// not grey: for ACEScg that row differs from AP1's row for its own white (0.2722, 0.6741, 0.0537), which would give
// 2700 K a luminance of 1.005.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/color/chromaticity.hpp>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// A linear RGB space.
struct RgbSpace {
    std::string name;
    glm::dmat3 to_xyz{1.0};   // columns are red, green, blue
    glm::dmat3 from_xyz{1.0}; // its inverse
};

// XYZ → XYZ, by linear Bradford (Lam 1985), which scales cone-like responses: `from` of luminance 1 becomes `to` of
// luminance 1. Both need y > 0.
glm::dmat3 bradford(Xy from, Xy to);

// Y of (1,0,0), (0,1,0), (0,0,1).
glm::dvec3 luminance_row(const RgbSpace& space);

// A space by its name in text.
struct RgbSpaceName {
    std::string_view name;
    std::string_view alias; // may be empty
    std::string_view says;
};

// The built-in spaces: rec709, rec2020, p3-d65, acescg, aces2065-1, xyz.
std::span<const RgbSpaceName> rgb_spaces();

// By name or alias; nullptr if there is none.
const RgbSpace* find_rgb_space(std::string_view name);

// From the chromaticities of the primaries and of RGB (1,1,1). Fails (usage) if they do not span a space.
Result<RgbSpace> rgb_space_of(std::string name, Xy red, Xy green, Xy blue, Xy white);

// From a matrix ACES2065-1 → RGB: the form in which spaces from other programs' configurations are entered. Fails
// (unsupported) if the matrix has no inverse.
Result<RgbSpace> rgb_space_of_aces(std::string name, const glm::dmat3& from_aces2065_1);

// What becomes of a colour outside the space.
enum class Gamut {
    keep, // including negative components
    clip  // negative ones to 0, then scaled back to the luminance
};
// How bright the RGB of a chromaticity is.
enum class Normalize {
    luminance, // Y = 1: photometric numbers keep their meaning
    max        // the greatest component is 1
};

// The colour of a light in a space.
struct SpaceColor {
    glm::dvec3 rgb{0.0};
    double luminance = 1.0;      // of rgb: below 1 for Normalize::max
    bool in_gamut = true;        // before clipping: no component below −1e-9
    double delta_uv_prime = 0.0; // the change caused by clipping
};

// The colour of a chromaticity with v > 0 in a space.
SpaceColor to_space(Uv at, const RgbSpace& space, Gamut gamut = Gamut::keep,
                    Normalize normalize = Normalize::luminance);

// The chromaticity of an RGB. Fails (usage) on black, on a luminance that is not above 0, and on values that are not
// finite.
Result<Uv> uv_of_rgb(const glm::dvec3& rgb, const RgbSpace& space);

// IEC 61966-2-1, in both directions.
double decode_srgb(double encoded);
double encode_srgb(double linear);

} // namespace gonio
#pragma GCC visibility pop
