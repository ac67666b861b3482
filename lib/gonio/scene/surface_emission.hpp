// What a surface of a stage emits by itself: an amount and a colour, "500nt" or "800lm,color=3000K".
//
// The surface is a Lambertian emitter of the same luminance everywhere on its lit side, in addition to what its
// material reflects. An amount has the meaning that it has for the area light of the surface's shape: sphere (sphere),
// tube (capsule), one-sided rect (panel). A box emits from its six faces: Φ = π A L with A = 2 (w h + w d + h d). It
// has no direction, so an intensity and an illuminance at a distance are refused for it. A plane cannot emit: it has no
// end, so neither a flux nor an area light of its shape.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/light/photometric_value.hpp>
#include <gonio/light/photometry.hpp>
#include <gonio/scene/primitives.hpp>

#include <glm/vec3.hpp>

#include <optional>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

class FileScope;

// What a surface emits, besides what it reflects.
struct SurfaceEmission {
    PhotometricValue amount;
    glm::dvec3 color{1.0}; // linear Rec.709 of luminance 1
};

// "AMOUNT" or "AMOUNT,color=COLOR", both as for a light (parse_photometric_value, parse_light_color). Remarks about the
// colour are appended to `diagnostics` if it is given; a spectrum may be any file or, if `files` is given, one that
// `files` allows. Fails (usage) as these do, on an amount that is missing or 0, and on other keys.
Result<SurfaceEmission> parse_surface_emission(std::string_view text, Diagnostics* diagnostics = nullptr,
                                               FileScope* files = nullptr);

// The area of the lit side of a surface [m²]; infinite for a plane.
double lit_area(const Primitive& geometry);

// The shape of the area light that a sphere, a capsule or a panel is; nothing for a box, which is six of them, and for
// a plane.
std::optional<Shape> light_shape(const Primitive& geometry);

// A surface by its size alone, as conversions of amounts need it: "box:w=20cm,h=10cm,d=5cm", "panel:w=1m,h=50cm" or
// "capsule:r=2cm,l=30cm" (l without the round ends). Nothing for other kinds. Fails (usage) on keys and lengths as
// parse_shape() does.
Result<std::optional<Primitive>> parse_surface_size(std::string_view text);

// The luminance of a surface that emits this amount. `steps`, if given, receives the steps of the conversion. Fails
// (usage) on a plane, on units that the surface does not have, on a luminance that is not greater than 0 and on one
// above greatest_amount (base/amount_range.hpp).
Result<Nits> emitted_luminance(const Primitive& geometry, const PhotometricValue& amount,
                               ConversionSteps* steps = nullptr);

// What a surface of this luminance emits, in another unit. Fails (usage) as above.
Result<double> express_emission(const Primitive& geometry, Nits luminance, const PhotometricUnit& unit,
                                ConversionSteps* steps = nullptr);

} // namespace gonio
#pragma GCC visibility pop
