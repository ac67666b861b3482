// SceneContent: what the writer of a target gets. It has lights of the kinds that the target supports, in its unit of
// length; for a whole scene also the surfaces, their materials and the camera.
//
// light_scene() and stage_scene() make it and call Target::files with it. For a program that is not in targets(),
// define a Target with `files` that turns this into text.
#pragma once

#include <gonio/asset/measured_light.hpp>
#include <gonio/asset/target.hpp>
#include <gonio/base/frame.hpp>
#include <gonio/base/quantity.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/primitives.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// What every target can store of a material: a Lambertian part, and a GGX lobe with Schlick's reflectance from f0 to 1
// at grazing.
struct SceneMaterial {
    std::string name;                 // unique in the scene: letters, digits and '_'
    glm::dvec3 diffuse{0.0};          // albedo: share of uniform light from all sides that the diffuse part reflects
    glm::dvec3 f0{0.0};               // 0: no lobe
    double alpha = 1.0;               // the α in D and V; most targets take its root as roughness
    std::optional<GltfMaterial> gltf; // used instead by a target that has glTF's own material
    std::optional<Coat> coat;         // only for a target that has coats
    bool is_anisotropic = false;      // its lobe, of which alpha is the mean

    // Whether the part reflects anything.
    bool has_diffuse() const { return diffuse != glm::dvec3(0.0); }
    bool has_lobe() const { return f0 != glm::dvec3(0.0); }
};

using SceneShape = std::variant<Panel, Ball, Box, Capsule>; // a plane is a panel of plane_size

// A surface of a scene.
struct SceneSurface {
    std::string name; // unique in the scene: letters, digits and '_'
    SceneShape shape;
    std::size_t material = 0; // index
};

// The camera of a scene.
struct SceneCamera {
    Frame frame;               // looks along −Z, Y is up
    double vertical_fov = 0.0; // full angle of the picture [rad]
    int width = 0;             // of the picture [pixels]
    int height = 0;

    double aspect() const { return static_cast<double>(width) / height; }
};

// The surfaces of a scene, and the camera.
struct SceneStage {
    std::vector<SceneMaterial> materials;
    std::vector<SceneSurface> surfaces;
    SceneCamera camera;
    std::optional<Nits> white; // the luminance that our picture shows as 1
    int bounces = 0;           // how often light is reflected before it reaches the surface that the camera sees
    bool shows_backs = false;  // the camera is behind a one-sided surface, which our camera looks through
    bool shows_sky = false;    // to the camera, where it sees no surface
};

// A light of a kind that the target supports.
struct SceneLight {
    LightKind kind = LightKind::point;
    std::string name;       // unique in the scene: letters, digits and '_', for a single luminaire '-' too
    Frame frame;            // as Light::frame; the origin in the target's unit
    glm::dvec3 color{1.0};  // linear Rec.709 of luminance 1
    double intensity = 0.0; // along the direction; a profile: its peak; an area: A L or π r² L. In candela, unless the
                            // target has no unit of its own: then times the square of the units per metre, so that
                            // dividing by the square of a distance in units gives lux
    double nits = 0.0;  // of areas and the sun
    double lux = 0.0;   // of the sun, on a plane across its direction
    double inner = 0.0; // half angles of a spot [rad], 0 ≤ inner < outer
    double outer = 0.0;
    double radius = 0.0;                  // of a sphere, a disk, a tube, a cylinder [unit]
    double width = 0.0;                   // of an ellipse and a rectangle along X; a tube's cylinder, a cylinder
    double height = 0.0;                  // of an ellipse and a rectangle along Y
    double diameter = 0.0;                // of the sun [rad]
    std::optional<double> range;          // [unit]; only where the target has the window
    std::size_t profile = 0;              // of a profile: index
    std::optional<std::size_t> luminaire; // index; then its luminance is that of the luminaire
    std::size_t image = 0; // of a projector and a panel: index; `intensity` or `nits` is that of texels of 1
};

// A luminaire with a size, only for a target whose area lights take profiles: SceneLight::luminaire of its faces names
// it. Towards a direction ω of its frame all of them have the luminance `scale` I(ω)/Σ areaᵢ max(nᵢ·ω, 0), with the
// intensity I of its profile and the sum over `facing`; without facing areas `scale` I(ω), and I is a luminance.
struct SceneLuminaire {
    // A face of the opening.
    struct Facing {
        glm::dvec3 normal{0.0}; // unit; of a sphere 0, whose projected area is the same from everywhere
        double area = 0.0;      // [unit²]
    };
    std::string name; // unique in the scene
    Frame frame;
    std::size_t profile = 0; // index
    double scale = 1.0;
    std::vector<Facing> facing;
};

// The image of a projector or a panel. detail/scene_image.hpp makes pictures of it.
struct SceneImage {
    std::string name;                   // of its file, without the ending
    std::shared_ptr<const Light> light; // in metres
    double peak = 0.0;                  // cd of a projector or nt of a panel that a channel of 1 stands for
    int width = 0;                      // of the image as it was given [pixels]
    int height = 0;
    double slope_x = 0.0; // of a projector: half of the width that it covers one metre before it [m]
    double slope_y = 0.0;
};

// The light from all around. A picture is a file beside that of the target; without one it is uniform.
struct SceneSky {
    std::string name;         // unique among the lights and surfaces of the scene: letters, digits and '_'
    std::string picture;      // of the kind that the target reads; empty: uniform
    int picture_height = 0;   // of a lat-long, which is twice as wide [texels]
    double nits_per_unit = 1; // cd/m² of a pixel of Y = 1
    double nits = 0.0;        // uniform: the luminance from every direction
    glm::dvec3 color{1.0};    // uniform: linear Rec.709 of luminance 1
    double lux = 0.0;         // on an open horizontal plane, without the sun
};

// Everything that a target's writer gets.
struct SceneContent {
    std::string name;
    std::string description; // without line ends, ASCII
    double units_per_meter = 1.0;
    std::vector<MeasuredLight> profiles; // with the names of their files
    std::vector<SceneImage> images;
    std::vector<SceneLuminaire> luminaires;
    std::vector<SceneLight> lights;
    std::optional<SceneSky> sky;     // only if the target stores skies
    bool single = false;             // a single luminaire, with the profile's own name
    bool photometric = false;        // LightSceneOptions::photometric
    std::optional<SceneStage> stage; // in metres; if present, the file is a whole scene
};

} // namespace gonio
#pragma GCC visibility pop
