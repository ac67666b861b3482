#include <gonio/asset/detail/radiance_text.hpp>
#include <gonio/asset/detail/scene_sky.hpp>
#include <gonio/asset/detail/scene_text.hpp>
#include <gonio/asset/stage_scene.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/scene/emissive_lights.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gonio {

namespace {

using namespace asset_detail;

constexpr std::array formats{
    StageFormat{".gltf", "glTF 2.0 with .bin and .ies beside it", "gltf", false, gltf_text_files},
    StageFormat{".glb", "glTF 2.0 in one file", "gltf", false, gltf_binary_files},
    StageFormat{".usda", "OpenUSD with UsdLux, UsdPreviewSurface", "usd", false, usd_files},
    StageFormat{".pbrt", "pbrt-v4", "pbrt", true, pbrt_files},
    StageFormat{".xml", "Mitsuba 3", "mitsuba", true, mitsuba_files},
    StageFormat{".rad", "Radiance", "radiance", true, radiance_files},
    StageFormat{".py", "a Blender script that creates a scene for Cycles", "blender", true, blender_files},
};

// A square of an infinite plane, with its middle at the foot of the perpendicular from the eye.
Panel cut(const Plane& plane, const glm::dvec3& eye) {
    const glm::dvec3 middle = eye - glm::dot(eye - plane.point, plane.normal) * plane.normal;
    return panel_facing(middle, plane.normal, {0.0, 1.0, 0.0}, plane_size.value, plane_size.value);
}

SceneShape scene_shape(const Primitive& primitive, const glm::dvec3& eye) {
    if (const auto* plane = std::get_if<Plane>(&primitive)) return cut(*plane, eye);
    if (const auto* panel = std::get_if<Panel>(&primitive)) return *panel;
    if (const auto* ball = std::get_if<Ball>(&primitive)) return *ball;
    if (const auto* box = std::get_if<Box>(&primitive)) return *box;
    return std::get<Capsule>(primitive);
}

// The camera as CameraRays uses it.
SceneCamera scene_camera(const Camera& camera, int width, int height) {
    const double half_height = std::tan(0.5 * degrees(camera.vertical_fov_deg).value);
    const double half_width = std::tan(0.5 * degrees(camera.least_horizontal_fov_deg).value);
    return {aimed_frame(camera.position, camera.target - camera.position, camera.up),
            2.0 * std::atan(std::max(half_height, half_width * height / width)), width, height};
}

class StageBuilder {
public:
    // `has_gltf`: the target's own material is glTF's. `has_coats`: it stores a clear coat.
    StageBuilder(const glm::dvec3& eye, bool has_gltf, bool has_coats, asset_detail::TakenNames& names,
                 std::vector<std::string>& instead)
        : eye_(eye), has_gltf_(has_gltf), has_coats_(has_coats), names_(names), instead_(instead) {}

    void add(const Surface& surface) {
        const SceneShape shape = scene_shape(surface.geometry, eye_);
        if (const auto* panel = std::get_if<Panel>(&shape))
            stage_.shows_backs |= glm::dot(eye_ - panel->frame.origin, panel->frame.z) < 0.0;
        stage_.surfaces.push_back({unique_name(surface.name, names_), shape, material_of(surface)});
    }

    SceneStage& stage() { return stage_; }

private:
    // Surfaces with the same name and the same material share one entry.
    std::size_t material_of(const Surface& surface) {
        std::vector<std::string> losses;
        SceneMaterial material = scene_material(surface.material, losses);
        if (has_gltf_ && material.gltf) losses.clear();
        // The shapes of the targets have no tangents.
        if (material.is_anisotropic) losses.emplace_back("its anisotropic lobe is written as an even one");
        if (material.coat && has_coats_)
            losses.emplace_back("what its coat leaves of the material below follows the rule of the other program");
        else if (std::exchange(material.coat, std::nullopt))
            losses.emplace_back("its clear coat is left out");
        for (const std::string& loss : losses) {
            std::string line = fmt::format("surface '{}': {}", surface.name, loss);
            if (std::find(instead_.begin(), instead_.end(), line) == instead_.end())
                instead_.push_back(std::move(line));
        }
        for (std::size_t i = 0; i < stage_.materials.size(); ++i) {
            const SceneMaterial& other = stage_.materials[i];
            if (sources_[i] == surface.name && other.diffuse == material.diffuse && other.f0 == material.f0 &&
                other.alpha == material.alpha && other.gltf == material.gltf && other.coat == material.coat)
                return i;
        }
        material.name = unique_name(surface.name + "_material", names_);
        stage_.materials.push_back(std::move(material));
        sources_.push_back(surface.name);
        return stage_.materials.size() - 1;
    }

    glm::dvec3 eye_;
    bool has_gltf_;
    bool has_coats_;
    asset_detail::TakenNames& names_;
    std::vector<std::string>& instead_;
    SceneStage stage_;
    std::vector<std::string> sources_; // the surfaces' name for each material
};

} // namespace

std::span<const StageFormat> stage_formats() {
    return formats;
}

Result<const StageFormat*> stage_format_of(std::string_view file) {
    std::string known;
    for (const StageFormat& format : formats) {
        if (file.size() > format.extension.size() && file.ends_with(format.extension)) return &format;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", format.extension);
    }
    return fail("USE0103", fmt::format("a scene cannot be written as '{}'", file),
                fmt::format("the name must end in one of {}", known));
}

Result<LightScene> stage_scene(const StageFormat& format, const Stage& stage, const Camera& camera,
                               std::span<const Light> lights, const StageSceneOptions& options) {
    const Target& target = **find_target(format.target);
    Result<BuiltScene> built =
        scene_content(target, lights, {options.name, options.description, Meters(1.0), options.sky});
    if (!built) return pass_on(built);
    asset_detail::TakenNames names;
    for (const SceneLight& light : built->content.lights)
        names.names.insert(light.name);
    if (built->content.sky) names.names.insert(built->content.sky->name);
    StageBuilder builder(camera.position, format.target == "gltf", format.target == "gltf" || format.target == "usd",
                         names, built->instead);
    const EmittedLights emitted(stage, lights);
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i) {
        if (!emitted.emits(i)) {
            builder.add(stage.surfaces[i]);
            continue;
        }
        // The same surface twice, once as a light, would block itself.
        built->instead.push_back(fmt::format("surface '{}' emits: it is written as its light alone, without a material",
                                             stage.surfaces[i].name));
    }
    SceneStage& made = builder.stage();
    made.camera = scene_camera(camera, options.width, options.height);
    const bool mixes = format.target == "pbrt" || format.target == "mitsuba";
    for (const SceneMaterial& material : made.materials) {
        const glm::dvec3 diffuse = mixed(material).diffuse;
        if (mixes && std::max({diffuse.x, diffuse.y, diffuse.z}) > 1.0)
            built->instead.push_back(fmt::format("{}: its albedo and its coloured reflection together exceed what {} "
                                                 "can mix: an albedo above 1 is written",
                                                 material.name, format.target));
    }
    if (format.target == "radiance")
        for (const SceneMaterial& material : made.materials)
            if (asset_detail::radiance_clips(material))
                built->instead.push_back(
                    fmt::format("{}: Radiance cannot have so bright or saturated a colour, which is "
                                "clipped",
                                material.name));
    made.white = options.white;
    made.bounces = options.bounces;
    if (options.bounces > 0 && options.bounces_matter && !format.has_bounces)
        built->instead.push_back(fmt::format("{} does not store a number of bounces: set {} where you render it",
                                             format.extension, options.bounces));
    if (made.shows_backs && mixes)
        built->instead.push_back(
            fmt::format("the camera is behind a one-sided wall: {} shows the back of the wall", format.target));
    made.shows_sky = options.shows_sky;
    if (built->content.sky && !options.shows_sky && !target.holds.sky.is_hidden)
        built->instead.emplace_back("the camera sees the sky too, as it does here with --show-sky");
    built->content.stage = std::move(made);
    LightScene scene{format.files(built->content), std::move(built->instead)};
    asset_detail::add_sky_file(built->content, options.sky, target.holds.sky, scene.files);
    return scene;
}

} // namespace gonio
