// StageScene: the scene that a picture of a stage is rendered from, so that other renderers can check the picture.
//
// It has the same surfaces, camera and lights, in the target's units: lights as in light_scene.hpp, Z up and metres
// where the target leaves the choice. Pictures rendered from it are scene-linear: 1 is 1 cd/m²
// (Blender: 177.83 cd/m²).
//
//   a plane      infinite in gonio, here a square of plane_size with the camera above its middle
//   solids       the target's own; glTF and Blender get meshes with smooth normals and corners on the surface; their
//                faces lie inside by at most ball_sag of the radius
//   a material   a Lambertian part of the same albedo and a GGX lobe of the same α and f0; what is lost is reported
//   shadows      of all surfaces
//   bounces      none, as gonio renders, or the number that the options ask for; where the format has no such setting,
//                it is reported
//
// One-sided surfaces are lit and seen from one side; if a renderer shows the back and the camera sees it, that is
// reported.
#pragma once

#include <gonio/asset/light_scene.hpp>
#include <gonio/asset/target.hpp>
#include <gonio/base/quantity.hpp>
#include <gonio/scene/stage.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// The side of the panel that a plane becomes.
inline constexpr Meters plane_size{2000.0};

inline constexpr int max_bounces = 1024; // Cycles' own limit

// 1 − cos(π/128): 256 corners around.
inline constexpr double ball_sag = 3.1e-4;

// A kind of file.
struct StageFormat {
    std::string_view extension; // ".gltf"
    std::string_view summary;   // for lists
    std::string_view target;    // the target of its lights
    bool has_bounces;           // it says how often a renderer reflects light
    std::vector<AssetFile> (*files)(const SceneContent& scene);
};

// All of them.
std::span<const StageFormat> stage_formats();

// The format for the ending of a file's name. Fails (usage) on others.
Result<const StageFormat*> stage_format_of(std::string_view file);

// How stage_scene() writes.
struct StageSceneOptions {
    std::string name;        // of the files: letters, digits, '_' and '-'
    std::string description; // for a comment in them
    int width = 512;         // of the picture [pixels]
    int height = 512;
    std::optional<Nits> white;       // the luminance that our picture shows as 1, stated in the files
    int bounces = 0;                 // [0, max_bounces], how often the renderer reflects light between surfaces
    bool bounces_matter = true;      // false: no report where the format cannot store them
    const SkyPicture* sky = nullptr; // as LightSceneOptions::sky
    bool shows_sky = false;          // to the camera
};

// The first file is the scene; it reads the others from beside it. Fails as light_scene() does.
Result<LightScene> stage_scene(const StageFormat& format, const Stage& stage, const Camera& camera,
                               std::span<const Light> lights, const StageSceneOptions& options);

} // namespace gonio
#pragma GCC visibility pop
