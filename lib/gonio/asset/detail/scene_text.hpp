// What the writers of targets share: the content of a scene, axes, text, meshes, pictures.
#pragma once

#include <gonio/asset/detail/scene_stage.hpp>
#include <gonio/asset/light_scene.hpp>
#include <gonio/asset/measured_light.hpp>
#include <gonio/asset/scene_content.hpp>
#include <gonio/asset/target.hpp>
#include <gonio/bake/bake.hpp>
#include <gonio/base/frame.hpp>

#include <glm/ext/vector_int3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::asset_detail {

struct BuiltScene {
    SceneContent content;
    std::vector<std::string> instead;
};

// What light_scene() writes, before it becomes text.
Result<BuiltScene> scene_content(const Target& target, std::span<const Light> lights, const LightSceneOptions& options);

// Ratio of the inner to the outer half angle of a spot with a hard edge: no target accepts two equal angles.
inline constexpr double hard_edge = 0.9995;

// A vector of the right-handed world with Z up, in the axes of other programs.
inline glm::dvec3 y_up(const glm::dvec3& v) {
    return {v.x, v.z, -v.y};
}
inline glm::dvec3 left_handed_y_up(const glm::dvec3& v) {
    return {v.x, v.z, v.y};
}
inline glm::dvec3 left_handed_z_up(const glm::dvec3& v) {
    return {v.x, -v.y, v.z};
}

// "4.56 lm, peak 1.23 cd, of lamp.ies": describes the light in a comment of a written file. Without line ends.
std::string describe(const MeasuredLight& light);

// One line of ASCII; any other byte becomes '?'.
std::string ascii(std::string_view text);

// A string literal of JSON, which is also one of Python, JavaScript and C#; pure ASCII.
std::string quoted(std::string_view text);

// "x, y, z", with the given separator.
std::string triple(const glm::dvec3& v, std::string_view separator = ", ");

// A name for languages that allow only letters, digits and '_', and no digit first.
std::string identifier(std::string_view name);

// Numbers from 0 to 1 as unsigned 16-bit numbers in base64, the lower byte first.
std::string texels_in_base64(const std::vector<double>& texels);

// A colour with a greatest channel of 1, and the factor that restores its luminance.
struct ScaledColor {
    glm::dvec3 rgb;
    double factor;
};
ScaledColor scaled(const glm::dvec3& color);

// The range of a light [unit], for programs in which every light has one. If the light does not specify it, the window
// takes away at most `window_loss_lx`, which the files state: ⟨1 − (d/r)⁴⟩² takes away at most 1.0887 I/r². Engines
// compute a light wherever its range reaches, so that it must not be too long.
inline constexpr double window_loss_lx = 0.1;
double reach_of(const SceneLight& light, double units_per_meter = 1.0);

// Triangles of a mesh; normals point outwards.
struct Mesh {
    std::vector<glm::dvec3> points;
    std::vector<glm::ivec3> faces;
};

// A capsule along X: `length` is that of the cylinder, with hemispheres at its ends. The mesh has the capsule's area.
Mesh capsule_mesh(double radius, double length);

// The side of a cylinder along X, without its ends, of equal area.
Mesh cylinder_mesh(double radius, double length);

// A rectangle across −Z, with its normal along −Z.
Mesh rectangle_mesh(double width, double height);

// The same for an ellipse, as a polygon of equal area.
Mesh ellipse_mesh(double half_width, double half_height);

// The texture that an engine of gonio/bake/engine.hpp reads, as stored in the file.
AssetPicture engine_picture(std::string_view engine, const Web& web);

// The same for other options, which must not fail for any web.
AssetPicture baked_picture(const Web& web, BakeOptions options, int channels = 1);

// A stage in a Blender script: the first part begins the script, the second comes after the lights and calls their
// place().
std::string blender_stage_start(const SceneContent& scene);
std::string blender_stage(const SceneStage& stage, double lumens_per_watt);

// The stage of a scene for pbrt, written before its lights; the picture is named `picture`.exr.
std::string pbrt_stage(const SceneStage& stage, std::string_view picture);

// The part of a stage inside the prim `root`, and the part beside that prim.
std::string usd_stage(const SceneStage& stage, std::string_view root);
std::string usd_render_settings(const SceneStage& stage, std::string_view root);

// Writers of the targets that stages are written for too; target.cpp alone declares the writers of other targets.
std::vector<AssetFile> blender_files(const SceneContent& scene);
std::vector<AssetFile> gltf_text_files(const SceneContent& scene); // .gltf and the files that it reads
std::vector<AssetFile> gltf_binary_files(const SceneContent& scene);
std::vector<AssetFile> mitsuba_files(const SceneContent& scene);
std::vector<AssetFile> pbrt_files(const SceneContent& scene);
std::vector<AssetFile> radiance_files(const SceneContent& scene);
std::vector<AssetFile> usd_files(const SceneContent& scene);

} // namespace gonio::asset_detail
