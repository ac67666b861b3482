// Blender: a Python script that makes a point light of 1 W whose emission strength is the IES node's.
//
// Cycles' node multiplies candela by 4π/177.83 (Blender's lumens for a watt), so that a point light of 1 W shines with
// the file's candela, each 1/177.83 W/sr. It looks up H = atan2(x, y) + π and V = acos(−z): turning that vector gives
// azimuths as LM-63 counts them, from +X towards +Y. Between the table's lines Cycles interpolates by cubics, which
// overshoot where the light bends; on a table of four times as many lines a quarter of that is left. The profile is
// held by the .blend file.
#include <gonio/asset/detail/target_files.hpp>
#include <gonio/web/resample.hpp>
#include <gonio/web/to_profile.hpp>

#include <fmt/format.h>

#include <span>
#include <vector>

namespace gonio::asset_detail {

namespace {

constexpr const char* script = R"python(# {description}
# Makes the light {name} with its measured profile inside: a point light for Cycles, beam along -Z, C0 along +X.
# Lux are Blender's W/m2 times 177.83. Scale the light by its Power: 1 W is the profile as it is.
import bpy

PROFILE = (
{lines})
COLOR = ({red}, {green}, {blue})  # linear Rec.709 of luminance 1


def make_light(name):
    text = bpy.data.texts.new(name + ".ies")
    text.write(PROFILE)
    light = bpy.data.lights.new(name, "POINT")
    light.energy = 1.0
    light.shadow_soft_size = 0.0
    light.use_nodes = True
    nodes = light.node_tree.nodes
    links = light.node_tree.links
    nodes.clear()
    direction = nodes.new("ShaderNodeTexCoord")
    parts = nodes.new("ShaderNodeSeparateXYZ")
    links.new(direction.outputs["Normal"], parts.inputs[0])
    # The node counts azimuths from -Y towards -X: (x, y) becomes (-y, -x).
    turned = nodes.new("ShaderNodeCombineXYZ")
    for source, target in (("Y", "X"), ("X", "Y")):
        minus = nodes.new("ShaderNodeMath")
        minus.operation = "MULTIPLY"
        minus.inputs[1].default_value = -1.0
        links.new(parts.outputs[source], minus.inputs[0])
        links.new(minus.outputs[0], turned.inputs[target])
    links.new(parts.outputs["Z"], turned.inputs["Z"])
    profile = nodes.new("ShaderNodeTexIES")
    profile.mode = "INTERNAL"
    profile.ies = text
    profile.inputs["Strength"].default_value = 1.0
    links.new(turned.outputs[0], profile.inputs["Vector"])
    emission = nodes.new("ShaderNodeEmission")
    emission.inputs["Color"].default_value = COLOR + (1.0,)
    links.new(profile.outputs["Fac"], emission.inputs["Strength"])
    output = nodes.new("ShaderNodeOutputLight")
    links.new(emission.outputs[0], output.inputs["Surface"])
    luminaire = bpy.data.objects.new(name, light)
    bpy.context.scene.collection.objects.link(luminaire)
    return luminaire


make_light({quoted_name})
)python";

// The angles and as many between each two of them as make `parts`.
std::vector<double> refined(std::span<const double> angles, std::size_t parts) {
    std::vector<double> finer;
    for (std::size_t i = 0; i + 1 < angles.size(); ++i)
        for (std::size_t k = 0; k < parts; ++k)
            finer.push_back(angles[i] +
                            (angles[i + 1] - angles[i]) * static_cast<double>(k) / static_cast<double>(parts));
    finer.push_back(angles.back());
    return finer;
}

// The profile on a finer grid where that does not make it huge, else as it is.
std::string finer_profile(const MeasuredLight& light) {
    constexpr std::size_t most_values = 200000;
    const Web& web = light.web;
    std::size_t parts = 4;
    while (parts > 1 && parts * parts * web.planes_deg().size() * web.gammas_deg().size() > most_values)
        parts /= 2;
    if (parts == 1) return light.portable_ies;
    Result<ResampledWeb> finer =
        resampled_to_c(web, refined(web.planes_deg(), parts), refined(web.gammas_deg(), parts), web.stored_symmetry());
    Result<MadeProfile> made =
        finer ? to_profile(finer->web, light.header, ProfileTarget::portable) : Result<MadeProfile>(pass_on(finer));
    return made ? write_profile(made->profile, ProfileTarget::portable) : light.portable_ies;
}

// The profile's lines as adjacent string literals.
std::string literals(std::string_view text) {
    std::string lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        lines += "    " + quoted(std::string(line) + "\n") + "\n";
    }
    return lines;
}

} // namespace

std::vector<AssetFile> blender_files(const MeasuredLight& light) {
    using namespace fmt::literals;
    std::string text =
        fmt::format(script, "description"_a = describe(light), "name"_a = light.name,
                    "lines"_a = literals(finer_profile(light)), "red"_a = light.color.x, "green"_a = light.color.y,
                    "blue"_a = light.color.z, "quoted_name"_a = quoted(light.name));
    return {{light.name + ".py", std::move(text), {}}};
}

} // namespace gonio::asset_detail
