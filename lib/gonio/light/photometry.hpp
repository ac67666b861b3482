// Photometric conversion: the flux, intensity, illuminance and luminance of a shape, each computed from any other.
//
//   point, spot, frustum   Φ = Ω I, Ω the solid angle of the lobe (gonio/light/lobe.hpp), 4π for a point
//     with a mask          Φ = ∬ lobe · mask dω I₀ (gonio/light/masked_flux.hpp), I₀ the intensity where both are 1
//   web                    Φ = (flux of the web / its peak) I, I its peak
//   sphere                 Φ = 4π² r² L,  I = π r² L
//   disk, rectangle        Φ = π A L, twice that when two-sided,  I = A L
//   tube                   Φ = π (2π r l + 4π r²) L,  I = (2 r l + π r²) L from the side
//   sun                    E = π sin²(δ/2) L; no flux, no intensity
// "cd" is the intensity along the shape's direction as emitted, including any mask (a web: its peak; a tube: from the
// side). "lx@d" is the illuminance of a receiver that faces the light at distance d from its centre along its
// direction, exact for the shape (gonio/light/closed_forms.hpp); for a web it is taken along γ = 0. The sun's "lx" is
// on a plane perpendicular to its direction and takes no distance. For disks and rectangles, cd, lx and nt are per
// side.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/light/photometric_value.hpp>
#include <gonio/light/shape.hpp>
#include <gonio/light/shape_factors.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// One step of the conversion from the given value to the requested one.
struct ConversionStep {
    std::string formula; // "I = Φ/4π"
    double value = 0.0;  // of the left-hand side
    std::string unit;
};

// The steps of a conversion, in order.
using ConversionSteps = std::vector<ConversionStep>;

// How much light a shape emits, in the quantities that apply to it; the others are 0.
struct Emission {
    Candelas intensity; // along the direction, before a mask; a web's peak, a tube's from the side; not of the sun
    Nits luminance;     // of area shapes and the sun
    Lux illuminance;    // of the sun, on a plane perpendicular to its direction
};

// The conversions of one shape, prepared once for many values. A web or a mask is integrated only when the first flux
// is needed.
class ShapePhotometry {
public:
    // Profiles and masks must be loaded. Fails (usage) on a web or a mask that is dark in every direction.
    static Result<ShapePhotometry> of(Shape shape);

    // `steps`, if given, receives the steps of the conversion. Fails (usage) if the combination has no meaning (nits of
    // a point, lumens of the sun, a distance inside the shape, a missing distance), and on results too large or too
    // small for a number.
    Result<Emission> emission_of(const PhotometricValue& value, ConversionSteps* steps = nullptr);

    // An emission of this shape, expressed in `unit`. Fails as above, and on the exposure value of 0. Where the inverse
    // square is not exact, `steps` also receives the inverse-square value and its relative error.
    Result<double> express(const Emission& emission, const PhotometricUnit& unit, ConversionSteps* steps = nullptr);

    // The distance from the shape's centre at which a receiver that faces it gets `illuminance` > 0, exact for the
    // shape: beyond that distance the receiver gets less. Fails (usage) for the sun, for a shape that is dark along its
    // direction, and if the illuminance is less even on contact; relative error below 1e-14.
    Result<Meters> distance_of(const Emission& emission, Lux illuminance) const;

private:
    ShapePhotometry(Shape shape, ShapeFactors factors);
    const Factor& flux();
    Result<double> strength_of(const PhotometricValue& value, ConversionSteps* steps);

    Shape shape_;
    ShapeFactors factors_;
    std::optional<Factor> flux_; // set when first needed
};

// The same for a single value.
Result<Emission> emission_of(const Shape& shape, const PhotometricValue& value, ConversionSteps* steps = nullptr);
Result<double> express(const Shape& shape, const Emission& emission, const PhotometricUnit& unit,
                       ConversionSteps* steps = nullptr);
Result<Meters> distance_of(const Shape& shape, const Emission& emission, Lux illuminance);

// Whether both are units of luminance (nt, fL, ev), or both of illuminance without a distance (lx, fc, evlx): between
// them, the shape of the light does not matter.
bool same_quantity(const PhotometricUnit& a, const PhotometricUnit& b);

// The value in another unit of the same quantity. Fails (usage) on the exposure value of 0 and on results too large for
// a number.
Result<double> convert_unit(const PhotometricValue& value, const PhotometricUnit& unit,
                            ConversionSteps* steps = nullptr);

// The emission of `to` that has the flux of `from`: the same lamp in another shape. Fails as emission_of() and
// express() do.
Result<Emission> with_same_flux(const Shape& from, const Emission& emission, const Shape& to);

} // namespace gonio
#pragma GCC visibility pop
