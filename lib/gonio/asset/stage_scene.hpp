// StageScene: what a picture of a stage is rendered from, for other renderers to check it by.
//
// The very surfaces, camera and lights, in the target's units: lights as light_scene.hpp has them, Z up and metres
// where the target leaves the choice. The pictures made of it are scene-linear: 1 is 1 cd/m², in Blender 177.83 cd/m².
//
//   a plane      has no end here: a square of plane_size, in the middle of which the camera stands
//   solids       the target's own; glTF and Blender have meshes with smooth normals whose corners lie on the surface,
//                whose faces lie inside by at most ball_sag of the radius
//   a material   a Lambertian part of the same albedo and a GGX lobe of the same α and f0; what is more is named
//   shadows      of all that stands there; bounces are the renderer's own affair, ours has none (set where that is
//                possible)
//
// A sheet is lit and seen from one side; where a renderer shows its back and the camera sees that, it is said.
#pragma once

#include <gonio/asset/light_scene.hpp>
#include <gonio/asset/target.hpp>
#include <gonio/base/quantity.hpp>
#include <gonio/scene/stage.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace gonio {

inline constexpr Meters plane_size{2000.0};

// 1 − cos(π/128): of 256 corners around.
inline constexpr double ball_sag = 3.1e-4;

// A kind of file.
struct StageFormat {
    std::string_view extension; // ".gltf"
    std::string_view summary;   // for lists
    std::string_view target;    // whose lights it holds
    std::vector<AssetFile> (*files)(const SceneContent& scene);
};

std::span<const StageFormat> stage_formats();

// By the ending of a file's name. Fails (usage) on others.
Result<const StageFormat*> stage_format_of(std::string_view file);

struct StageSceneOptions {
    std::string name;        // of the files: letters, digits, '_' and '-'
    std::string description; // for a comment in them
    int width = 512;         // of the picture [pixels]
    int height = 512;
    std::optional<Nits> white; // the luminance that our picture shows as 1, said in the files
};

// The first file is the scene; it reads the others from beside it. Fails as light_scene() does.
Result<LightScene> stage_scene(const StageFormat& format, const Stage& stage, const Camera& camera,
                               std::span<const Light> lights, const StageSceneOptions& options);

} // namespace gonio
