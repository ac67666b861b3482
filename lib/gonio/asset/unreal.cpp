// Unreal Engine: the portable profiles and a Python script for the editor, which imports them and places the lights.
//
// Left-handed, Z up, centimetres; the engine takes candela unchanged and scales them itself. A light's +X is the aim.
// For a profile, −Y is C0 and −Z is C90, along which a source length lies; its candela are used (bUseIESBrightness)
// times IESBrightnessScale. A spot falls as the square of a linear function of the cosine. Every light has an
// attenuation radius; if the light does not specify one, its window takes away at most `window_loss_lx`. A long-lat has
// −Y in its middle and +X to the right; a sky light has nits of its texels × its intensity.
#include <gonio/asset/detail/scene_text.hpp>

#include <fmt/format.h>

#include <numbers>

namespace gonio::asset_detail {

namespace {

constexpr const char* head = R"python(# {description}
# Run in the editor: Tools > Execute Python Script. Places the lights; profiles are imported from beside this file.
# A light without a range of its own ends where this takes away at most {loss} lx.
import os

import unreal

FOLDER = "/Game/Lights"


def place(name, kind, position, x, y):
    rotation = unreal.MathLibrary.make_rot_from_xy(unreal.Vector(*x), unreal.Vector(*y))
    actor = unreal.EditorLevelLibrary.spawn_actor_from_class(kind, unreal.Vector(*position), rotation)
    actor.set_actor_label(name)
    return actor.light_component


# The colour is linear, its greatest channel 1.
def setup(light, color, intensity, units, **properties):
    if units is not None:
        light.set_editor_property("intensity_units", units)
    light.set_editor_property("intensity", intensity)
    light.set_light_color(unreal.LinearColor(*color, 1.0))
    for name, value in properties.items():
        light.set_editor_property(name, value)
)python";

constexpr const char* importer = R"python(

def profile(name):
    task = unreal.AssetImportTask()
    task.filename = os.path.join(os.path.dirname(os.path.abspath(__file__)), name + ".ies")
    task.destination_path = FOLDER
    task.destination_name = name.replace(".", "_")
    task.automated = True
    task.replace_existing = True
    task.save = True
    unreal.AssetToolsHelpers.get_asset_tools().import_asset_tasks([task])
    return unreal.load_asset(FOLDER + "/" + task.destination_name)
)python";

constexpr const char* sky_text = R"python(

def sky(name, picture, intensity):
    task = unreal.AssetImportTask()
    task.filename = os.path.join(os.path.dirname(os.path.abspath(__file__)), picture)
    task.destination_path = FOLDER
    task.destination_name = picture.replace(".", "_")
    task.automated = True
    task.replace_existing = True
    task.save = True
    unreal.AssetToolsHelpers.get_asset_tools().import_asset_tasks([task])
    actor = unreal.EditorLevelLibrary.spawn_actor_from_class(unreal.SkyLight, unreal.Vector(0.0, 0.0, 0.0))
    actor.set_actor_label(name)
    light = actor.light_component
    light.set_mobility(unreal.ComponentMobility.MOVABLE)
    setup(light, (1.0, 1.0, 1.0), intensity, None, source_type=unreal.SkyLightSourceType.SLS_SPECIFIED_CUBEMAP,
          cubemap=unreal.load_asset(FOLDER + "/" + task.destination_name), source_cubemap_angle=0.0,
          lower_hemisphere_is_black=False)
    light.recapture_sky()
)python";

std::string vector(const glm::dvec3& v) {
    return "(" + triple(v) + ")";
}

std::string statement(const SceneLight& light, const SceneContent& scene) {
    const ScaledColor color = scaled(light.color);
    const auto place = [&](std::string_view kind, const glm::dvec3& y) {
        return fmt::format("light = place({}, unreal.{}, {}, {}, {})\n", quoted(light.name), kind,
                           vector(left_handed_z_up(light.frame.origin)), vector(left_handed_z_up(-light.frame.z)),
                           vector(left_handed_z_up(y)));
    };
    const auto setup = [&](double intensity, const std::string& more, bool candela = true) {
        return fmt::format("setup(light, {}, {}, {}{})\n", vector(color.rgb), intensity,
                           candela ? "unreal.LightUnits.CANDELAS" : "None", more);
    };
    const std::string reach = fmt::format(", attenuation_radius={}", reach_of(light, scene.units_per_meter));
    constexpr double degree = 180.0 / std::numbers::pi;
    switch (light.kind) {
    case LightKind::spot:
        return place("SpotLight", light.frame.x) +
               setup(color.factor * light.intensity,
                     fmt::format("{}, source_radius=0.0, inner_cone_angle={}, outer_cone_angle={}", reach,
                                 light.inner * degree, light.outer * degree));
    case LightKind::rect:
        return place("RectLight", light.frame.x) +
               setup(color.factor * light.intensity,
                     fmt::format("{}, source_width={}, source_height={}, barn_door_length=0.0", reach, light.width,
                                 light.height));
    case LightKind::sun:
        return place("DirectionalLight", light.frame.x) +
               setup(color.factor * light.lux, fmt::format(", light_source_angle={}", light.diameter * degree), false);
    case LightKind::profile:
        return place("PointLight", -light.frame.x) +
               setup(light.intensity,
                     fmt::format("{}, source_radius={}{}, ies_texture=profile({}), use_ies_brightness=True, "
                                 "ies_brightness_scale={}",
                                 reach, light.radius,
                                 light.width > 0.0 ? fmt::format(", source_length={}", light.width) : std::string(),
                                 quoted(scene.profiles[light.profile].name), color.factor));
    default:
        return place("PointLight", light.frame.x) +
               setup(color.factor * light.intensity, fmt::format("{}, source_radius={}", reach, light.radius));
    }
}

} // namespace

std::vector<AssetFile> unreal_files(const SceneContent& scene) {
    using namespace fmt::literals;
    std::string text = fmt::format(head, "description"_a = scene.description, "loss"_a = window_loss_lx);
    if (!scene.profiles.empty()) text += importer;
    if (scene.sky) text += sky_text;
    text += "\n\n";
    for (const SceneLight& light : scene.lights)
        text += statement(light, scene);
    if (scene.sky)
        text += fmt::format("# {:.6g} lx on the horizontal\nsky({}, {}, {})\n", scene.sky->lux, quoted(scene.sky->name),
                            quoted(scene.sky->picture), scene.sky->nits_per_unit);
    std::vector<AssetFile> files{{scene.name + ".py", std::move(text), {}}};
    for (const MeasuredLight& profile : scene.profiles)
        files.push_back({profile.name + ".ies", profile.portable_ies, {}});
    return files;
}

} // namespace gonio::asset_detail
