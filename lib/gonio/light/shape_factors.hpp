// The factors between a shape's strength and its other photometric quantities. Its strength is the intensity along its
// direction before a mask (a web's peak, a tube's from the side), or the illuminance of the sun.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/light/shape.hpp>

#include <optional>

#pragma GCC visibility push(default)
namespace gonio {

// A constant ratio between two quantities of a shape, and its formula.
struct Factor {
    double value = 0.0;
    const char* formula = ""; // "Φ = 4π I"
};

// Everything that needs no integration and no distance.
struct ShapeFactors {
    bool at_infinity = false;
    std::optional<Factor> luminance; // strength/L; empty if luminance has no meaning
    const char* no_luminance = "";   // why not
    const char* strength = "I";      // its symbol
    double axial_share = 1.0;        // intensity along the direction (a web: along γ = 0) over the strength
    double peak_cd = 0.0;            // of the web or the mask; of an image 1
    double nearest_m = 0.0;          // a distance below this is inside the shape
};

// Profiles and masks must be loaded. Fails (usage) on a web or a mask that is dark in every direction.
Result<ShapeFactors> shape_factors(const Shape& shape);

// Φ over the strength; not for the sun. Costs an integration if there is a web.
Factor flux_factor(const Shape& shape, const ShapeFactors& factors);

// E over the strength for a receiver that faces the shape at `distance` ≥ nearest_m; 1 for the sun.
Factor facing_factor(const Shape& shape, const ShapeFactors& factors, Meters distance);

// Whether the illuminance of a receiver that faces the shape falls with the square of the distance at every distance.
bool inverse_square_is_exact(const Shape& shape);

} // namespace gonio
#pragma GCC visibility pop
