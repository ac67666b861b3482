// Light: shape, amount, colour and position, resolved once into the constants that the inner loops read.
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/light/photometric_value.hpp>
#include <gonio/light/shape.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

class ImagePlane;
class ImageSolidAngles;
class LuminousBody;
struct FaceEmission;

// The face of a stage's surface that emits a light (gonio/scene/emissive_lights.hpp). The surface does not block this
// light and receives nothing of it.
struct EmittingFace {
    std::size_t surface = 0; // its index on the stage
    int face = 0;            // of a box; 0 for all others
};

// What a rig or a command line specifies for one light.
struct LightDescription {
    std::string name;
    Shape shape;
    std::optional<PhotometricValue> intensity; // a profile without one emits as measured; other shapes need it
    glm::dvec3 color{1.0, 1.0, 1.0};           // linear Rec.709 of luminance 1
    glm::dvec3 position{0.0, 0.0, 0.0};        // of the shape's centre [m]
    glm::dvec3 direction{0.0, 0.0, -1.0};      // in which it emits, any length > 0
    glm::dvec3 up{0.0, 1.0, 0.0};              // C90 of a web points there
    Radians rotation;                          // about the direction, seen along it: C0 towards C90
    std::optional<Meters> range;               // absent: no window
    std::optional<EmittingFace> emitted_by{};  // absent: a light that is not a surface of the stage
    double level = 1.0;                        // of its amount: dimming times maintenance factor, from 0 to 1
};

// A light as the inner loops read it.
struct Light {
    std::string name;
    Shape shape;        // profiles and masks loaded
    Frame frame;        // Z = −direction; γ = 0 of a web is −Z, C0 is X, C90 is Y; a rectangle's width, a tube's
                        // axis and the horizontal of a frustum run along X
    glm::dvec3 color;   // linear Rec.709 of luminance 1
    Candelas intensity; // along the direction, before a mask; a web: its peak after scaling; 0 for the sun
    Nits luminance;     // of area shapes and the sun, 0 for punctual shapes
    Lux illuminance;    // of the sun on a plane perpendicular to its direction, 0 for other shapes
    double web_scale = 1.0; // factor on the candela of a web (to the emitted ones) or of a mask (to 1 at its peak)
    std::optional<Meters> range;
    std::optional<EmittingFace> emitted_by{};
    // What the light consists of, if it is several: their light together is that of this light. The faces of a luminous
    // opening (luminaire.hpp), or red, green and blue of a coloured image.
    std::shared_ptr<const std::vector<Light>> parts{};
    std::shared_ptr<const LuminousBody> body{};     // of a profile with an opening
    std::shared_ptr<const FaceEmission> emission{}; // of a face of it
    std::shared_ptr<const ImagePlane> image{};      // of a light with an image: its luminance, or the colour of a part
    // Of a coloured image; shared by lights with the same image and shape (gonio/light/light_parts.hpp).
    std::shared_ptr<const ImageSolidAngles> image_solid_angles{};

    // Whether the surface with this index on the stage emits it.
    bool is_emitted_by(std::size_t surface) const { return emitted_by && emitted_by->surface == surface; }

    // The luminance of an area light towards a world direction (from the light to the receiver) of any length > 0, over
    // `luminance`: what its mask lets through, or what the profile of a face emits; 1 without either; of an image the
    // mean. Not negative.
    double luminance_share(const glm::dvec3& direction) const;
    // The same where the ray from `viewer` along `toward`, of any length > 0, meets the light: with an image, that
    // place of it, or the nearest one if the ray misses the light.
    double luminance_share_at(const glm::dvec3& viewer, const glm::dvec3& toward) const;
    // Whether an area light is other than uniform: depends on the direction, or has an image.
    bool has_pattern() const;

    // Intensity towards a world direction (from the light to the receiver) of any length > 0. For a punctual shape it
    // includes lobe, mask and web; for an area shape it is the luminance times the area projected towards a distant
    // receiver; for a profile with an opening it is that of the profile, as from far away; for the sun it is 0. A disk
    // and a rectangle emit backwards only when two-sided.
    Candelas intensity_towards(const glm::dvec3& direction) const;
};

// Loads the profile or the mask, if there is one; warnings and notes are appended to `diagnostics`. Fails as
// load_profile and emission_of do, and (usage) on a position that is not finite, a zero direction, a range that is not
// greater than 0, a level outside 0 to 1, or a shape without an intensity.
Result<Light> resolve_light(LightDescription description, Diagnostics& diagnostics);

// Resolves each, in order, and adds it to the lights. Fails as resolve_light().
Result<void> add_resolved(std::vector<LightDescription> descriptions, std::vector<Light>& lights,
                          Diagnostics& diagnostics);

} // namespace gonio
#pragma GCC visibility pop
