// What the writers of targets share: how a scene comes to them, axes, text, meshes, pictures.
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

// What light_scene() writes, before it is text.
Result<BuiltScene> scene_content(const Target& target, std::span<const Light> lights, const LightSceneOptions& options);

// Half angle of a hard spot's inner cone over its outer one: no target takes two that are the same.
inline constexpr double hard_edge = 0.9995;

// Axes of other programs, of a vector of the right-handed world with Z up.
inline glm::dvec3 y_up(const glm::dvec3& v) {
    return {v.x, v.z, -v.y};
}
inline glm::dvec3 left_handed_y_up(const glm::dvec3& v) {
    return {v.x, v.z, v.y};
}
inline glm::dvec3 left_handed_z_up(const glm::dvec3& v) {
    return {v.x, -v.y, v.z};
}

// "4.56 lm, peak 1.23 cd, of lamp.ies": what a comment in a written file says of the light. Without line ends.
std::string describe(const MeasuredLight& light);

// On one line of ASCII; what is not becomes '?'.
std::string ascii(std::string_view text);

// A string literal of JSON, which is one of Python, of JavaScript and of C# too; pure ASCII.
std::string quoted(std::string_view text);

// "x, y, z"; the separator as given.
std::string triple(const glm::dvec3& v, std::string_view separator = ", ");

// A name for languages that take letters, digits and '_' only, and no digit first.
std::string identifier(std::string_view name);

// A colour whose greatest channel is 1, and the factor that gives back its luminance.
struct ScaledColor {
    glm::dvec3 rgb;
    double factor;
};
ScaledColor scaled(const glm::dvec3& color);

// How far a light's window must reach so as to take away at most 0.01 lx [m]: 1.0887 I/r² is the most that
// ⟨1 − (d/r)⁴⟩² does.
double generous_range(double candela);

// Triangles: a mesh whose normals point outwards.
struct Mesh {
    std::vector<glm::dvec3> points;
    std::vector<glm::ivec3> faces;
};

// A capsule along X: `length` of the cylinder, hemispheres at its ends. Its area is that of the capsule.
Mesh capsule_mesh(double radius, double length);

// A rectangle across −Z, which its normal points along.
Mesh rectangle_mesh(double width, double height);

// The same of an ellipse, as a polygon of its area.
Mesh ellipse_mesh(double half_width, double half_height);

// The texture that an engine of gonio/bake/engine.hpp reads, as the file holds it.
AssetPicture engine_picture(std::string_view engine, const Web& web);

// The same for options of one's own, that do not fail for any web.
AssetPicture baked_picture(const Web& web, BakeOptions options, int channels = 1);

// What a script for Blender has of a stage: before all else, and after the lights, whose place() it calls.
std::string blender_stage_start(const SceneContent& scene);
std::string blender_stage(const SceneStage& stage, double lumens_per_watt);

// The stage of a scene for pbrt, before its lights; the picture is called `picture`.exr.
std::string pbrt_stage(const SceneStage& stage, std::string_view picture);

// What the prim `root` has of a stage, and what stands beside it.
std::string usd_stage(const SceneStage& stage, std::string_view root);
std::string usd_render_settings(const SceneStage& stage, std::string_view root);

// The files of the targets that stages are written for too; those of the others are named by target.cpp alone.
std::vector<AssetFile> blender_files(const SceneContent& scene);
std::vector<AssetFile> gltf_text_files(const SceneContent& scene); // .gltf and what it reads
std::vector<AssetFile> gltf_binary_files(const SceneContent& scene);
std::vector<AssetFile> mitsuba_files(const SceneContent& scene);
std::vector<AssetFile> pbrt_files(const SceneContent& scene);
std::vector<AssetFile> usd_files(const SceneContent& scene);

} // namespace gonio::asset_detail
