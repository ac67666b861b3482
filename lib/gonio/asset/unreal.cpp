// Unreal Engine: the portable profile and a Python script for the editor, which imports it and places a point light.
//
// The engine takes candela from the profile (bUseIESBrightness) times IESBrightnessScale. A light's +X is γ = 0, its −Y
// is C0 and its −Z is C90 in a left-handed frame: pitch −90° points it down, roll 90° takes C0 to the world's +X, and
// C90 to −Y, which is +Y of a right-handed world seen in this one.
#include <gonio/asset/detail/target_files.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace gonio::asset_detail {

namespace {

constexpr const char* script = R"python(# {description}
# Run in the editor: Tools > Execute Python Script. Imports {name}.ies from beside this file and places the light.
import os

import unreal

NAME = {quoted_name}
FOLDER = "/Game/Lights"

task = unreal.AssetImportTask()
task.filename = os.path.join(os.path.dirname(os.path.abspath(__file__)), NAME + ".ies")
task.destination_path = FOLDER
task.automated = True
task.replace_existing = True
task.save = True
unreal.AssetToolsHelpers.get_asset_tools().import_asset_tasks([task])

# Down, C0 along +X.
actor = unreal.EditorLevelLibrary.spawn_actor_from_class(
    unreal.PointLight, unreal.Vector(0.0, 0.0, 250.0), unreal.Rotator(roll=90.0, pitch=-90.0, yaw=0.0)
)
actor.set_actor_label(NAME)
light = actor.point_light_component
light.set_editor_property("intensity_units", unreal.LightUnits.CANDELAS)
light.set_editor_property("ies_texture", unreal.load_asset(FOLDER + "/" + NAME))
light.set_editor_property("use_ies_brightness", True)
# The colour below has 1 as its greatest channel: this gives back the luminance that it takes.
light.set_editor_property("ies_brightness_scale", {scale})
light.set_light_color(unreal.LinearColor({red}, {green}, {blue}, 1.0))
light.set_editor_property("source_radius", 0.0)
)python";

} // namespace

std::vector<AssetFile> unreal_files(const MeasuredLight& light) {
    using namespace fmt::literals;
    const glm::dvec3& color = light.color;
    const double most = std::max({color.x, color.y, color.z});
    std::string text = fmt::format(script, "description"_a = describe(light), "name"_a = light.name,
                                   "quoted_name"_a = quoted(light.name), "scale"_a = most, "red"_a = color.x / most,
                                   "green"_a = color.y / most, "blue"_a = color.z / most);
    return {{light.name + ".py", std::move(text), {}}, {light.name + ".ies", light.portable_ies, {}}};
}

} // namespace gonio::asset_detail
