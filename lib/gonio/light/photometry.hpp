// Photometric conversion: what a flux, an intensity, an illuminance or a luminance of a shape means in the others.
//
// Everything goes through the intensity along the shape's direction (a web: its peak):
//   point    Φ = 4π I
//   sphere   Φ = 4π I,  I = π r² L
//   web      Φ = (flux of the web / its peak) I
// E at distance d on a receiver that faces the light is I/d² for these three, exactly, the sphere included (Lambert).
// A web's E is taken along γ = 0.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/shape.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {

// A photometric unit; an illuminance also says at what distance from the light's centre.
struct PhotometricUnit {
    const Unit* unit = nullptr;
    std::optional<Meters> distance;
};

struct PhotometricValue {
    double number = 0.0;
    PhotometricUnit unit;
    std::optional<double> efficacy_lm_per_w; // of a value in watts
};

// "nt", "lx@2m", "evlx@30cm". Fails (usage) on units of other dimensions, on an illuminance without a distance and on
// a distance that is not greater than 0.
Result<PhotometricUnit> parse_photometric_unit(std::string_view text);

// "800lm", "300lx@2m", "12ev", "60W@90lm/W" (or "60W@683"). Fails (usage) as above, and on negative amounts.
Result<PhotometricValue> parse_photometric_value(std::string_view text);

// One line of the way from the given value to the asked one.
struct ConversionStep {
    std::string formula; // "I = Φ/4π"
    double value = 0.0;  // of the left-hand side
    std::string unit;
};

using ConversionSteps = std::vector<ConversionStep>;

// The intensity along the shape's direction. `steps`, where given, receives what was done. A ProfileShape must be
// loaded. Fails (usage) where the pair has no meaning: nits of a point, a distance inside the sphere, candela of a dark
// web.
Result<Candelas> intensity_of(const Shape& shape, const PhotometricValue& value, ConversionSteps* steps = nullptr);

// The number of `unit`s that an intensity is for this shape. Fails as above, and on the exposure value of 0.
Result<double> express(const Shape& shape, Candelas intensity, const PhotometricUnit& unit,
                       ConversionSteps* steps = nullptr);

} // namespace gonio
