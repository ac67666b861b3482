// Targets: the programs that lights are written for, each with its own files, units and conventions.
//
// gonio/asset/light_scene.hpp writes them.
#pragma once

#include <gonio/bake/texture.hpp>
#include <gonio/base/image.hpp>
#include <gonio/base/result.hpp>
#include <gonio/light/shape.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {

struct SceneContent; // gonio/asset/scene_content.hpp

// A picture that a target reads beside its text; the caller that writes the files stores it.
struct AssetPicture {
    Image image; // as the file holds it
    TexelType texel_type = TexelType::float32;
};

// One file of an asset.
struct AssetFile {
    std::string name;  // in the target's folder
    std::string bytes; // if the file is not a picture
    std::optional<AssetPicture> picture;
};

enum class LightKind { point, spot, profile, sphere, disk, ellipse, rect, tube, sun };

// A target's unit of length.
enum class TargetLength { any, meter, centimeter, none };

// The kinds of light that a target has; every target has profiles.
struct TargetHolds {
    std::span<const LightKind> kinds;    // besides profiles and spots
    std::optional<Falloff> spot_falloff; // of its spots; nothing: it has no spots
    bool spot_has_inner = true;          // false: they fall from the axis on, and have no hard edge
    bool range = false;                  // a window ⟨1 − (d/r)⁴⟩² over distance
    double widest_spot_deg = 90.0;       // outer half angle
    TargetLength length = TargetLength::any;
    bool point_radius = false; // its points have a radius, for shadows and highlights
    bool profile_size = false; // its profiles have a radius and a length across them, as a tube has
};

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
