// Light: shape, amount, colour and place, resolved once into the constants that the inner loops read.
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/light/photometry.hpp>
#include <gonio/light/shape.hpp>

#include <glm/vec3.hpp>

#include <optional>
#include <string>

namespace gonio {

// What a rig or a command line says of one light.
struct LightDescription {
    std::string name;
    Shape shape;
    std::optional<PhotometricValue> intensity; // a profile without one shines as measured; other shapes need it
    glm::dvec3 color{1.0, 1.0, 1.0};           // linear Rec.709 of luminance 1
    glm::dvec3 position{0.0, 0.0, 0.0};        // of the shape's centre [m]
    glm::dvec3 direction{0.0, 0.0, -1.0};      // along which it shines, any length > 0
    glm::dvec3 up{0.0, 1.0, 0.0};              // C90 of a web points there
    Radians rotation;                          // of the light about its direction, as seen along it: C0 towards C90
    std::optional<Meters> range;               // absent: no window
};

struct Light {
    std::string name;
    Shape shape;            // profiles loaded
    Frame frame;            // Z = −direction; γ = 0 of a web is −Z, C0 is X, C90 is Y
    glm::dvec3 color;       // linear Rec.709 of luminance 1
    Candelas intensity;     // along the direction; a web: its peak as scaled
    Nits luminance;         // of a sphere, 0 for shapes without area
    double web_scale = 1.0; // factor on the web's candela
    std::optional<Meters> range;

    // Intensity towards a world direction (from the light to the receiver) of any length > 0.
    Candelas intensity_towards(const glm::dvec3& direction) const;
};

// Loads the profile where there is one; what was noticed is appended to `diagnostics`. Fails as load_profile and
// intensity_of do, and (usage) on a position that is not finite, a zero direction, a range that is not greater than 0,
// a shape without an intensity.
Result<Light> resolve_light(LightDescription description, Diagnostics& diagnostics);

} // namespace gonio
