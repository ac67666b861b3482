#include <gonio/base/kind_text.hpp>
#include <gonio/interchange/engine_script.hpp>

#include <array>
#include <vector>

namespace gonio {

namespace {

constexpr std::string_view unreal =
    R"python(# Lists the lights of the open level for `gonio lights`, as lights.json beside the project.
# Run it in the editor: Tools > Execute Python Script. Needs the plugin "Python Editor Script Plugin".
import json
import os

import unreal

KINDS = (
    ("SpotLight", unreal.SpotLightComponent),  # before the point light, which it is derived from
    ("PointLight", unreal.PointLightComponent),
    ("RectLight", unreal.RectLightComponent),
    ("DirectionalLight", unreal.DirectionalLightComponent),
    ("SkyLight", unreal.SkyLightComponent),
)
# Unreal's names of the properties; a component has some of them.
PROPERTIES = (
    "intensity", "use_temperature", "temperature", "attenuation_radius", "use_inverse_squared_falloff",
    "source_radius", "source_length", "source_width", "source_height", "inner_cone_angle", "outer_cone_angle",
    "light_source_angle", "use_ies_brightness", "ies_brightness_scale",
)


def numbers(vector):
    return [vector.x, vector.y, vector.z]


def described(actor, kind, component):
    light = {
        "name": actor.get_actor_label(),
        "kind": kind,
        "position": numbers(component.get_world_location()),
        "forward": numbers(component.get_forward_vector()),
        "up": numbers(component.get_up_vector()),
        "visible": component.is_visible(),
    }
    for name in PROPERTIES:
        try:
            light[name] = component.get_editor_property(name)
        except Exception:  # not a property of this component
            pass
    try:
        light["intensity_units"] = component.get_editor_property("intensity_units").name
    except Exception:
        pass
    color = component.get_light_color()
    light["color"] = [color.r, color.g, color.b]
    try:
        profile = component.get_editor_property("ies_texture")
        if profile:
            light["ies"] = profile.get_editor_property("asset_import_data").get_first_filename()
    except Exception:
        pass
    return light


lights = []
for actor in unreal.EditorLevelLibrary.get_all_level_actors():
    for component in actor.get_components_by_class(unreal.LightComponentBase):
        for kind, of in KINDS:
            if isinstance(component, of):
                lights.append(described(actor, kind, component))
                break
path = os.path.join(unreal.Paths.convert_relative_path_to_full(unreal.Paths.project_dir()), "lights.json")
with open(path, "w") as file:
    json.dump({"schema": "gonio.engine-lights/1", "program": "unreal", "lights": lights}, file, indent=1)
unreal.log("wrote " + path)
)python";

constexpr std::string_view unity =
    R"cs(// Lists the lights of the open scene for `gonio lights`, as lights.json beside Assets.
// Put it into a folder Assets/Editor, and choose Tools > List lights for gonio. For the HDRP of Unity 6.
using System.Globalization;
using System.IO;
using System.Text;
using UnityEditor;
using UnityEngine;

static class GonioLights
{
    static string Number(float value) { return value.ToString("R", CultureInfo.InvariantCulture); }

    static string Numbers(params float[] values)
    {
        return "[" + string.Join(", ", System.Array.ConvertAll(values, Number)) + "]";
    }

    static string Text(string value)
    {
        var text = new StringBuilder("\"");
        foreach (char c in value)
            if (c == '"' || c == '\\') text.Append('\\').Append(c);
            else if (c < ' ') text.AppendFormat("\\u{0:x4}", (int)c);
            else text.Append(c);
        return text.Append('"').ToString();
    }

    // The radius of HDRP's points and spots; 0 in the other pipelines.
    static float Radius(Light light)
    {
        var type = System.Type.GetType("UnityEngine.Rendering.HighDefinition.HDAdditionalLightData, "
                                       + "Unity.RenderPipelines.HighDefinition.Runtime");
        var data = type == null ? null : light.GetComponent(type);
        var radius = data == null ? null : type.GetProperty("shapeRadius");
        return radius == null ? 0f : (float)radius.GetValue(data);
    }

    [MenuItem("Tools/List lights for gonio")]
    static void List()
    {
        var lines = new StringBuilder();
        foreach (Light light in Object.FindObjectsByType<Light>(FindObjectsInactive.Include, FindObjectsSortMode.None))
        {
            Transform at = light.transform;
            Color color = light.color.linear;
            lines.Append(lines.Length > 0 ? ",\n" : "\n");
            lines.Append("  {\"name\": " + Text(light.name) + ", \"kind\": " + Text(light.type.ToString()));
            lines.Append(", \"intensity\": " + Number(light.intensity) + ", \"unit\": " + Text(light.lightUnit.ToString()));
            lines.Append(", \"color\": " + Numbers(color.r, color.g, color.b));
            lines.Append(", \"use_temperature\": " + (light.useColorTemperature ? "true" : "false"));
            lines.Append(", \"temperature\": " + Number(light.colorTemperature));
            lines.Append(", \"spot_angle\": " + Number(light.spotAngle));
            lines.Append(", \"inner_spot_angle\": " + Number(light.innerSpotAngle));
            lines.Append(", \"area_size\": " + Numbers(light.areaSize.x, light.areaSize.y));
            lines.Append(", \"radius\": " + Number(Radius(light)) + ", \"range\": " + Number(light.range));
            lines.Append(", \"has_cookie\": " + (light.cookie != null ? "true" : "false"));
            lines.Append(", \"position\": " + Numbers(at.position.x, at.position.y, at.position.z));
            lines.Append(", \"forward\": " + Numbers(at.forward.x, at.forward.y, at.forward.z));
            lines.Append(", \"up\": " + Numbers(at.up.x, at.up.y, at.up.z));
            lines.Append(", \"visible\": " + (light.isActiveAndEnabled ? "true" : "false") + "}");
        }
        string path = Path.GetFullPath("lights.json");
        File.WriteAllText(path, "{\"schema\": \"gonio.engine-lights/1\", \"program\": \"unity\", \"lights\": ["
                                + lines + "\n]}\n");
        Debug.Log("wrote " + path);
    }
}
)cs";

constexpr std::array scripts{
    EngineScript{"unity", "GonioLights.cs", unity},
    EngineScript{"unreal", "gonio_lights.py", unreal},
};

} // namespace

std::span<const EngineScript> engine_scripts() {
    return scripts;
}

Result<const EngineScript*> find_engine_script(std::string_view program) {
    std::vector<std::string_view> names;
    for (const EngineScript& script : scripts) {
        if (script.program == program) return &script;
        names.push_back(script.program);
    }
    return unknown_name("program", program, names);
}

} // namespace gonio
