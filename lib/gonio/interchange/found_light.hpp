// Lights as found in the scenes of other programs, in gonio's shapes, units and world: right-handed, Z up, metres.
//
// A reader of gonio/interchange/scene_format.hpp makes them. What the scene does not state and what a rig cannot hold
// is a remark of the light: nothing is guessed in silence.
#pragma once

#include <gonio/base/diagnostic_codes.hpp>
#include <gonio/base/diagnostics.hpp>
#include <gonio/base/quantity.hpp>
#include <gonio/light/photometric_value.hpp>
#include <gonio/light/shape.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// Something that a reader assumed, or that is lost.
struct LightRemark {
    const DiagnosticCode* code = nullptr; // of the family SCN
    std::string message;                  // without the light's name, the same for all lights that it concerns
    std::string hint;                     // may be empty
};

// Full beam angles.
struct ZoomRange {
    Radians least;
    Radians most;
};

// A light of a scene.
struct FoundLight {
    std::string name;
    std::string place;                         // in the file: "nodes[3]", "/Scene/key"
    Location location;                         // of that place
    std::string kind;                          // as the format names it: "spot", "RectLight"
    std::string stated;                        // the amount as the file states it: "intensity 1200, color 1 0.8 0.6"
    std::optional<Shape> shape;                // nothing: only listed, a rig cannot hold it
    std::optional<PhotometricValue> intensity; // physical; a profile without one emits as measured
    double profile_scale = 1.0;                // of a profile: factor on its candela
    std::optional<std::size_t> profile;        // of a profile inside the file: index into FoundScene::profiles
    glm::dvec3 color{1.0, 1.0, 1.0};           // linear Rec.709 of luminance 1
    std::optional<Kelvin> temperature;         // if the file states one
    glm::dvec3 position{0.0, 0.0, 0.0};        // of the shape's centre [m]
    glm::dvec3 direction{0.0, 0.0, -1.0};      // in which it emits, unit length
    glm::dvec3 up{0.0, 1.0, 0.0};              // the shape's Y, unit length
    std::optional<Meters> range;               // absent: no window
    std::optional<ZoomRange> zoom;             // of a beam that can be made narrower and wider
    double stated_amount = 0.0;                // the amount's number, as in the file
    double stated_color_max = 1.0;             // the greatest channel of the colour, as in the file
    bool is_tinted = false;                    // the file states a colour other than grey
    std::optional<double> stated_outer;        // outer cone angle of a spot, as in the file
    std::optional<double> stated_inner;        // the inner one
    std::size_t index = 0;                     // of the light's own entry in the file, which others may share
    std::vector<LightRemark> remarks;          // what was assumed or is lost

    // Whether a rig can hold it.
    bool is_converted() const { return shape.has_value(); }
};

// A profile that is inside a scene's file.
struct FoundProfile {
    std::string name;  // of a file, without its ending: letters, digits, '_' and '-'
    std::string bytes; // of the file
    std::string ending = "ies";
};

// The lights of a scene, in the order of the file.
struct FoundScene {
    std::string source;                 // the name used in messages
    std::string format;                 // of scene_formats(): "gltf"
    std::string generator;              // the program that wrote the file, if it says so
    double meters_per_unit = 1.0;       // length of the scene's unit
    std::vector<FoundLight> lights;     // in the order of the file
    std::vector<FoundProfile> profiles; // inside the file
    Diagnostics diagnostics;            // about the whole file
};

// The scene's diagnostics, and the remarks of its lights: one for all lights that it concerns, at the first of them.
Diagnostics scene_diagnostics(const FoundScene& scene);

} // namespace gonio
#pragma GCC visibility pop
