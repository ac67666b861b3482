// Targets: the programs that lights are written for, each with its own files, units and conventions.
//
// gonio/asset/light_scene.hpp writes them.
#pragma once

#include <gonio/bake/texture.hpp>
#include <gonio/base/image.hpp>
#include <gonio/base/result.hpp>
#include <gonio/light/shape.hpp>
#include <gonio/sky/sun_light.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

class EnvironmentMap; // gonio/sky/environment_map.hpp
struct SceneContent;  // gonio/asset/scene_content.hpp

// A picture that a target reads beside its text; the caller that writes the files stores it.
struct AssetPicture {
    Image image; // as the file holds it
    TexelType texel_type = TexelType::float32;
};

// An environment image of linear Rec.709 that a target reads; the caller stores it, rounded to what its format holds,
// with the sidecar of environment_sidecar.hpp.
struct AssetEnvironment {
    std::shared_ptr<const EnvironmentMap> map;
    std::optional<SunLight> sun; // beside it: a light of the scene
    std::string source;          // what it was made from, as the user named it
    std::string source_sha256;   // of an image
};

// One file of an asset.
struct AssetFile {
    std::string name;  // in the target's folder
    std::string bytes; // if the file is neither a picture nor an environment
    std::optional<AssetPicture> picture;
    std::optional<AssetEnvironment> environment = {};
};

// The kinds of light that targets distinguish.
enum class LightKind {
    point,
    spot,
    profile,
    projector, // a spot or a frustum with an image
    sphere,
    disk,
    ellipse,
    rect,
    panel, // a rectangle with an image
    tube,
    cylinder,
    sun
};

// The picture that a target reads of a sky.
enum class SkyPictureKind : std::uint8_t {
    none,         // it stores no sky
    latlong,      // OpenEXR, as environment_layout.hpp has it: north in the middle
    latlong_hdr,  // the same as Radiance HDR
    latlong_rgbe, // the same for a reader that takes the middle of the interval that a mantissa stands for: Radiance
    equal_area    // OpenEXR, the square of equal_area_square.hpp
};

// What a target stores of a sky. The sun of a sky is a light of its own.
struct TargetSky {
    SkyPictureKind picture = SkyPictureKind::none;
    bool has_uniform = false; // it has a constant of its own; else a uniform sky is a picture, too
    bool is_hidden = false;   // of whole stages: the camera need not see it
    std::string_view reason;  // why it stores none, for a report
};

// What a target does with the images of lights. A projector that covers a cone alone gets a picture of the square
// around the cone in which the image lies.
struct TargetImages {
    double widest_projector_deg = 0.0; // from the axis to its corners; 0: it has no projectors
    bool has_panels = false;
    std::string_view loses; // what its projectors lose, for a report
};

// A target's unit of length.
enum class TargetLength { any, meter, centimeter, none };

// The kinds of light that a target has.
struct TargetHolds {
    std::span<const LightKind> kinds;    // besides profiles and spots
    std::optional<Falloff> spot_falloff; // of its spots; nothing: it has no spots
    bool spot_has_inner = true;          // false: they fall from the axis on, and have no hard edge
    bool range = false;                  // a window ⟨1 − (d/r)⁴⟩² over distance
    double widest_spot_deg = 90.0;       // outer half angle
    TargetLength length = TargetLength::any;
    bool point_radius = false; // its points have a radius, for shadows and highlights
    bool profile_size = false; // its profiles have a radius and a length across them, as a tube has
    TargetSky sky = {};
    TargetImages images = {};
    bool near_profiles = false; // its area lights take a profile and divide it by a projected area
    bool profiles = true;       // false: a spot or a point of the same flux stands for a profile
    bool azimuths = true;       // false: it averages a profile over them
    bool one_sun = false;       // a scene has one
};

// A program that files are written for, as `gonio list targets` shows it.
struct Target {
    std::string_view name;    // "gltf"
    std::string_view summary; // for lists
    // How to use the output, what was checked in the program itself and what could not be: one line each.
    std::string_view use, verified, unverified;
    TargetHolds holds;
    // Makes the target's files for a scene with lights of the kinds above, in its unit of length.
    std::vector<AssetFile> (*files)(const SceneContent& scene) = nullptr;
};

// By name.
std::span<const Target> targets();

// Fails (usage) on an unknown name.
Result<const Target*> find_target(std::string_view name);

// The target's README: use, what was verified, what could not be.
std::string target_readme(const Target& target);

} // namespace gonio
#pragma GCC visibility pop
