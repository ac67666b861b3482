// Blender: a Python script that makes the lights for Cycles, Z up.
//
// Watts are lumens divided by 177.83, Blender's own figure: a point of P W emits P/4π W/sr, an area P/4A W per m² and
// sr (so it emits π/4 of its power), a sun P W/m², a material its emission strength. A profile is a point light of 1 W
// with the IES node as its emission strength: Cycles' node multiplies candela by 4π/177.83, so that each candela gives
// 1/177.83 W/sr. The node looks up H = atan2(x, y) + π and V = acos(−z); rotating its input vector gives azimuths as
// LM-63 counts them, from +X towards +Y. Between the table's lines Cycles interpolates with cubics, which overshoot
// where the intensity curve bends; a table with four times as many lines leaves a quarter of the overshoot. The profile
// is stored inside the .blend file.
//
// A world's strength is W per m² and sr. An environment texture has the azimuth 0 of +X in its middle and +Y to its
// left; it is looked up by directions turned by −90° about Z, so that +Y is in its middle.
//
// A luminaire with a size is an empty with the area lights of its faces, whose emission is the IES node over the
// projected area: Incoming is the direction from a light to what it lights, in world axes (3.4 does not turn vectors
// into those of a light), and drivers give the nodes the axes of the empty. Each light has drivers of its own: Blender
// leads those of a duplicated light to the empty that was duplicated with it, but not those inside a shared node group.
//
// A projected image is a point light whose emission looks its picture up by the direction. An area light looks its
// picture up by its parameters, which run from 0 at −X and −Y to 1; a viewer in front has +X at the left.
//
// Spots are profiles too: Cycles 3.4 multiplies its own spots by the cosine to the axis, other releases do not.
#include <gonio/asset/detail/scene_image.hpp>
#include <gonio/asset/detail/scene_text.hpp>
#include <gonio/web/resample.hpp>
#include <gonio/web/to_profile.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace gonio::asset_detail {

namespace {

using std::numbers::pi;

constexpr double lumens_per_watt = 177.83;

constexpr const char* start = R"python(# {description}
# Makes the lights for Cycles. Lux are Blender's W/m2 times 177.83.
{imports}import bpy
from mathutils import Matrix
)python";

constexpr const char* place = R"python(

def place(name, data, position, x, y, z):
    light = bpy.data.objects.new(name, data)
    light.matrix_world = Matrix(
        [(x[i], y[i], z[i], position[i]) for i in range(3)] + [(0.0, 0.0, 0.0, 1.0)]
    )
    bpy.context.scene.collection.objects.link(light)
    return light


def new_light(name, kind, color, watts):
    light = bpy.data.lights.new(name, kind)
    light.color = color
    light.energy = watts
    if kind == "POINT":
        light.shadow_soft_size = 0.0
    return light
)python";

constexpr const char* node_helper = R"python(

def own_nodes(light):
    """Its nodes, of which there are none yet, and their links."""
    light.use_nodes = True
    light.node_tree.nodes.clear()
    return light.node_tree.nodes, light.node_tree.links


def math_node(nodes, links, operation, *values):
    node = nodes.new("ShaderNodeMath")
    node.operation = operation
    for socket, value in zip(node.inputs, values):
        if isinstance(value, (int, float)):
            socket.default_value = value
        else:
            links.new(value, socket)
    return node.outputs[0]


def direction(nodes, links):
    """From a point light to what it lights, in its own axes: x, y, z."""
    parts = nodes.new("ShaderNodeSeparateXYZ")
    links.new(nodes.new("ShaderNodeTexCoord").outputs["Normal"], parts.inputs[0])
    return parts.outputs


def shine(nodes, links, color, strength):
    """The emission of a light. Each is a value or an output; a colour is linear Rec.709 of luminance 1."""
    emission = nodes.new("ShaderNodeEmission")
    if isinstance(color, tuple):
        emission.inputs["Color"].default_value = color + (1.0,)
    else:
        links.new(color, emission.inputs["Color"])
    if isinstance(strength, (int, float)):
        emission.inputs["Strength"].default_value = strength
    else:
        links.new(strength, emission.inputs["Strength"])
    links.new(emission.outputs[0], nodes.new("ShaderNodeOutputLight").inputs["Surface"])
)python";

constexpr const char* profile_helper = R"python(

def look_up(nodes, links, text, strength, x, y, z):
    """The profile towards a direction of the light's own axes."""
    # The node counts azimuths from -Y towards -X: (x, y) becomes (-y, -x).
    turned = nodes.new("ShaderNodeCombineXYZ")
    links.new(math_node(nodes, links, "MULTIPLY", y, -1.0), turned.inputs["X"])
    links.new(math_node(nodes, links, "MULTIPLY", x, -1.0), turned.inputs["Y"])
    links.new(z, turned.inputs["Z"])
    profile = nodes.new("ShaderNodeTexIES")
    profile.mode = "INTERNAL"
    profile.ies = text
    profile.inputs["Strength"].default_value = strength
    links.new(turned.outputs[0], profile.inputs["Vector"])
    return profile.outputs["Fac"]


def profile_light(name, text, color, watts):
    light = new_light(name, "POINT", (1.0, 1.0, 1.0), watts)
    nodes, links = own_nodes(light)
    shine(nodes, links, color, look_up(nodes, links, text, 1.0, *direction(nodes, links)))
    return light


def profile_text(name, lines):
    text = bpy.data.texts.new(name)
    text.write(lines)
    return text
)python";

constexpr const char* tube_helper = R"python(

def glowing_mesh(name, points, faces, color, radiance):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], faces)
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    emission = nodes.new("ShaderNodeEmission")
    emission.inputs["Color"].default_value = color + (1.0,)
    emission.inputs["Strength"].default_value = radiance
    # Like other lights it stands in no light's way, nor does its inside shine through.
    links = material.node_tree.links
    clear = nodes.new("ShaderNodeMath")
    clear.operation = "MAXIMUM"
    links.new(nodes.new("ShaderNodeLightPath").outputs["Is Shadow Ray"], clear.inputs[0])
    links.new(nodes.new("ShaderNodeNewGeometry").outputs["Backfacing"], clear.inputs[1])
    shown = nodes.new("ShaderNodeMixShader")
    links.new(clear.outputs[0], shown.inputs[0])
    links.new(emission.outputs[0], shown.inputs[1])
    links.new(nodes.new("ShaderNodeBsdfTransparent").outputs[0], shown.inputs[2])
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(shown.outputs[0], output.inputs["Surface"])
    mesh.materials.append(material)
    return mesh
)python";

constexpr const char* luminaire_helper = R"python(

def drive(socket, thing, path):
    driver = socket.driver_add("default_value").driver
    driver.type = "SUM"
    variable = driver.variables.new()
    variable.targets[0].id = thing
    variable.targets[0].data_path = path


def dot(nodes, links, a, b):
    product = nodes.new("ShaderNodeVectorMath")
    product.operation = "DOT_PRODUCT"
    links.new(a, product.inputs[0])
    if isinstance(b, tuple):
        product.inputs[1].default_value = b
    else:
        links.new(b, product.inputs[1])
    return product.outputs["Value"]


def luminaire(name, position, x, y, z, text, scale, facing):
    """An empty for its place, and a node group for its luminance [W/m2/sr]: the profile over the projected area."""
    empty = place(name, None, position, x, y, z)
    group = bpy.data.node_groups.new(name, "ShaderNodeTree")
    for socket, way in (("X", "IN"), ("Y", "IN"), ("Z", "IN"), ("Luminance", "OUT")):
        if hasattr(group, "interface"):
            group.interface.new_socket(socket, in_out=way + "PUT", socket_type="NodeSocketFloat")
        else:
            (group.inputs if way == "IN" else group.outputs).new("NodeSocketFloat", socket)
    nodes = group.nodes
    links = group.links

    def node(operation, *values):
        return math_node(nodes, links, operation, *values)

    entry = nodes.new("NodeGroupInput")
    local = [entry.outputs[axis] for axis in "XYZ"]
    luminance = look_up(nodes, links, text, scale / (4.0 * math.pi), *local)
    if facing:
        along = nodes.new("ShaderNodeCombineXYZ")
        for socket, value in zip(along.inputs, local):
            links.new(value, socket)
        total = 1e-6 * sum(area for _, area in facing)
        for normal, area in facing:
            share = node("MAXIMUM", dot(nodes, links, along.outputs[0], normal), 0.0) if any(normal) else 1.0
            total = node("MULTIPLY_ADD", share, area, total)
        luminance = node("DIVIDE", luminance, total)
    links.new(luminance, nodes.new("NodeGroupOutput").inputs["Luminance"])
    return empty, group


def face_light(light, color, group, empty):
    """Shines as the group says for directions along the axes of the empty."""
    nodes, links = own_nodes(light)
    shared = nodes.new("ShaderNodeGroup")
    shared.node_tree = group
    towards = nodes.new("ShaderNodeNewGeometry").outputs["Incoming"]
    for column in range(3):
        axis = nodes.new("ShaderNodeCombineXYZ")
        for row in range(3):
            # Paths count columns first, unlike Python.
            drive(axis.inputs[row], empty, f"matrix_world[{column}][{row}]")
        links.new(dot(nodes, links, towards, axis.outputs[0]), shared.inputs["XYZ"[column]])
    shine(nodes, links, color, shared.outputs["Luminance"])


def attach(light, empty):
    light.parent = empty
    light.matrix_parent_inverse = empty.matrix_world.inverted()
)python";

constexpr const char* folder_helper = R"python(

def folder():
    """Of this script, also where Blender's text editor runs it."""
    text = getattr(bpy.context.space_data, "text", None)
    return os.path.dirname(bpy.path.abspath(text.filepath) if text and text.filepath else os.path.abspath(__file__))


def load_picture(file):
    image = bpy.data.images.load(os.path.join(folder(), file))
    image.colorspace_settings.name = "Non-Color"  # its numbers as they are: linear Rec.709
    return image
)python";

constexpr const char* image_helper = R"python(

def shine_picture(nodes, links, picture, u, v, beyond, strength):
    place = nodes.new("ShaderNodeCombineXYZ")
    links.new(u, place.inputs["X"])
    links.new(v, place.inputs["Y"])
    texture = nodes.new("ShaderNodeTexImage")
    texture.image = load_picture(picture)
    texture.extension = beyond
    links.new(place.outputs[0], texture.inputs["Vector"])
    shine(nodes, links, texture.outputs["Color"], strength)


def projector_light(name, picture, slope_x, slope_y, watts):
    light = new_light(name, "POINT", (1.0, 1.0, 1.0), watts)
    nodes, links = own_nodes(light)
    x, y, z = direction(nodes, links)

    def node(operation, *values):
        return math_node(nodes, links, operation, *values)

    ahead = node("MULTIPLY", z, -1.0)
    u = node("MULTIPLY_ADD", node("DIVIDE", x, ahead), 0.5 / slope_x, 0.5)
    v = node("MULTIPLY_ADD", node("DIVIDE", y, ahead), 0.5 / slope_y, 0.5)
    shine_picture(nodes, links, picture, u, v, "CLIP", node("GREATER_THAN", ahead, 0.0))
    return light


def panel_light(name, picture, watts):
    light = new_light(name, "AREA", (1.0, 1.0, 1.0), watts)
    nodes, links = own_nodes(light)
    parts = nodes.new("ShaderNodeSeparateXYZ")
    links.new(nodes.new("ShaderNodeNewGeometry").outputs["Parametric"], parts.inputs[0])
    u = math_node(nodes, links, "SUBTRACT", 1.0, parts.outputs["X"])
    shine_picture(nodes, links, picture, u, parts.outputs["Y"], "EXTEND", 1.0)
    return light
)python";

constexpr const char* sky_helper = R"python(

def sky_world(name, color, strength, picture):
    world = bpy.data.worlds.new(name)
    world.use_nodes = True
    nodes = world.node_tree.nodes
    links = world.node_tree.links
    nodes.clear()
    background = nodes.new("ShaderNodeBackground")
    background.inputs["Color"].default_value = color + (1.0,)
    background.inputs["Strength"].default_value = strength
    if picture:
        direction = nodes.new("ShaderNodeTexCoord")
        turned = nodes.new("ShaderNodeMapping")
        turned.inputs["Rotation"].default_value = (0.0, 0.0, math.radians(-90.0))
        links.new(direction.outputs["Generated"], turned.inputs["Vector"])
        sky = nodes.new("ShaderNodeTexEnvironment")
        sky.image = load_picture(picture)
        links.new(turned.outputs["Vector"], sky.inputs["Vector"])
        links.new(sky.outputs["Color"], background.inputs["Color"])
    links.new(background.outputs[0], nodes.new("ShaderNodeOutputWorld").inputs["Surface"])
    bpy.context.scene.world = world
    return world
)python";

// The angles, with each interval divided into `parts`.
std::vector<double> refined(std::span<const double> angles, std::size_t parts) {
    std::vector<double> finer;
    for (std::size_t i = 0; i + 1 < angles.size(); ++i)
        for (std::size_t k = 0; k < parts; ++k)
            finer.push_back(angles[i] +
                            (angles[i + 1] - angles[i]) * static_cast<double>(k) / static_cast<double>(parts));
    finer.push_back(angles.back());
    return finer;
}

// The profile on a finer grid if that does not make it huge, else unchanged.
std::string finer_profile(const MeasuredLight& light) {
    constexpr std::size_t most_values = 200000;
    const Web& web = light.web;
    std::size_t parts = 4;
    while (parts > 1 && parts * parts * web.planes_deg().size() * web.gammas_deg().size() > most_values)
        parts /= 2;
    if (parts == 1) return light.portable_ies;
    Result<Web> finer =
        sampled_on_grid(web, refined(web.planes_deg(), parts), refined(web.gammas_deg(), parts), web.stored_symmetry());
    Result<MadeProfile> made =
        finer ? to_profile(*finer, light.header, ProfileTarget::portable) : Result<MadeProfile>(pass_on(finer));
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

std::string tuple(const glm::dvec3& v) {
    return "(" + triple(v) + ")";
}

std::string mesh_lists(const Mesh& mesh) {
    std::string text = "[";
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        text += fmt::format("{}({:.9g}, {:.9g}, {:.9g}),", i % 4 == 0 ? "\n        " : " ", mesh.points[i].x,
                            mesh.points[i].y, mesh.points[i].z);
    text += "\n    ], [";
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        text += fmt::format("{}({}, {}, {}),", i % 8 == 0 ? "\n        " : " ", mesh.faces[i].x, mesh.faces[i].y,
                            mesh.faces[i].z);
    return text + "\n    ]";
}

// The statement that makes the light's data, followed by statements that set its properties.
std::string data_of(const SceneLight& light, const SceneContent& scene) {
    const ScaledColor color = scaled(light.color);
    const auto lamp = [&](std::string_view kind, double lumens) {
        return fmt::format("light = new_light({}, \"{}\", {}, {})\n", quoted(light.name), kind, tuple(color.rgb),
                           color.factor * lumens / lumens_per_watt);
    };
    const auto& l = light;
    switch (l.kind) {
    case LightKind::profile:
        return fmt::format("light = profile_light({}, texts[{}], {}, {})\n", quoted(l.name), l.profile, tuple(l.color),
                           l.intensity / scene.profiles[l.profile].peak.value);
    case LightKind::projector: {
        const SceneImage& image = scene.images[l.image];
        return fmt::format("light = projector_light({}, {}, {}, {}, {})\n", quoted(l.name), quoted(image.name + ".exr"),
                           image.slope_x, image.slope_y, 4.0 * pi * l.intensity / lumens_per_watt);
    }
    case LightKind::panel:
        return fmt::format("light = panel_light({}, {}, {})\n"
                           "light.shape = \"RECTANGLE\"\nlight.size = {}\nlight.size_y = {}\n",
                           quoted(l.name), quoted(scene.images[l.image].name + ".exr"),
                           4.0 * l.width * l.height * l.nits / lumens_per_watt, l.width, l.height);
    case LightKind::sphere:
        return lamp("POINT", 4.0 * pi * pi * l.radius * l.radius * l.nits) +
               fmt::format("light.shadow_soft_size = {}\n", l.radius);
    case LightKind::disk:
        return lamp("AREA", 4.0 * pi * l.radius * l.radius * l.nits) +
               fmt::format("light.shape = \"DISK\"\nlight.size = {}\n", 2.0 * l.radius);
    case LightKind::ellipse:
        return lamp("AREA", pi * l.width * l.height * l.nits) +
               fmt::format("light.shape = \"ELLIPSE\"\nlight.size = {}\nlight.size_y = {}\n", l.width, l.height);
    case LightKind::rect:
        return lamp("AREA", 4.0 * l.width * l.height * l.nits) +
               fmt::format("light.shape = \"RECTANGLE\"\nlight.size = {}\nlight.size_y = {}\n", l.width, l.height);
    case LightKind::tube:
        return fmt::format("light = glowing_mesh({}, {}, {}, {})\n", quoted(l.name),
                           mesh_lists(capsule_mesh(l.radius, l.width)), tuple(l.color), l.nits / lumens_per_watt);
    case LightKind::cylinder:
        return fmt::format("light = glowing_mesh({}, {}, {}, {})\n", quoted(l.name),
                           mesh_lists(cylinder_mesh(l.radius, l.width)), tuple(l.color), l.nits / lumens_per_watt);
    case LightKind::sun:
        return lamp("SUN", l.lux) + fmt::format("light.angle = {}\n", l.diameter);
    default:
        return lamp("POINT", 4.0 * pi * l.intensity);
    }
}

std::string text_of(const SceneLuminaire& luminaire) {
    std::string facing;
    for (const SceneLuminaire::Facing& face : luminaire.facing)
        facing += fmt::format("\n    ({}, {}),", tuple(face.normal), face.area);
    return fmt::format("empty, group = luminaire({}, {}, {}, {}, {}, texts[{}], {}, [{}\n])\n", quoted(luminaire.name),
                       tuple(luminaire.frame.origin), tuple(luminaire.frame.x), tuple(luminaire.frame.y),
                       tuple(luminaire.frame.z), luminaire.profile, luminaire.scale, facing);
}

std::string world_of(const SceneSky& sky) {
    return fmt::format("# {:.6g} lx on the horizontal\nworld = sky_world({}, {}, {}, {})\n", sky.lux, quoted(sky.name),
                       tuple(sky.color), (sky.picture.empty() ? sky.nits : sky.nits_per_unit) / lumens_per_watt,
                       sky.picture.empty() ? "None" : quoted(sky.picture));
}

// The modules that the script imports before Blender's own.
std::string imports_of(const SceneContent& scene) {
    std::string imports;
    if (scene.stage || scene.sky || !scene.luminaires.empty()) imports += "import math\n";
    if (scene.sky || !scene.images.empty()) imports += "import os\n";
    return imports.empty() ? imports : imports + "\n";
}

} // namespace

std::vector<AssetFile> blender_files(const SceneContent& scene) {
    using namespace fmt::literals;
    std::string text = fmt::format(start, "description"_a = scene.description, "imports"_a = imports_of(scene));
    if (scene.stage) text += blender_stage_start(scene);
    text += place;
    if (!scene.profiles.empty() || !scene.images.empty()) text += node_helper;
    if (!scene.profiles.empty()) text += profile_helper;
    const bool tubes = std::any_of(scene.lights.begin(), scene.lights.end(), [](const SceneLight& light) {
        return light.kind == LightKind::tube || light.kind == LightKind::cylinder;
    });
    if (tubes) text += tube_helper;
    if (scene.sky || !scene.images.empty()) text += folder_helper;
    if (!scene.images.empty()) text += image_helper;
    if (!scene.luminaires.empty()) text += luminaire_helper;
    if (scene.sky) text += sky_helper;
    text += "\n\n";
    if (!scene.profiles.empty()) {
        text += "texts = [\n";
        for (const MeasuredLight& profile : scene.profiles)
            text += fmt::format("    profile_text({}, (\n{}    )),\n", quoted(profile.name + ".ies"),
                                literals(finer_profile(profile)));
        text += "]\n";
    }
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const SceneLight& light = scene.lights[i];
        const std::string placed =
            fmt::format("place({}, light, {}, {}, {}, {})", quoted(light.name), tuple(light.frame.origin),
                        tuple(light.frame.x), tuple(light.frame.y), tuple(light.frame.z));
        if (!light.luminaire) {
            text += data_of(light, scene) + placed + "\n";
            continue;
        }
        // The faces of a luminaire follow each other.
        if (i == 0 || scene.lights[i - 1].luminaire != light.luminaire)
            text += text_of(scene.luminaires[*light.luminaire]);
        SceneLight face = light;
        face.nits = lumens_per_watt; // an emission of 1 is 1 W/m²/sr
        face.color = glm::dvec3(1.0);
        text += data_of(face, scene) +
                fmt::format("face_light(light, {}, group, empty)\nattach({}, empty)\n", tuple(light.color), placed);
    }
    if (scene.stage) text += blender_stage(*scene.stage, lumens_per_watt);
    if (scene.sky) text += world_of(*scene.sky);
    if (scene.sky && scene.stage && !scene.stage->shows_sky) text += "world.cycles_visibility.camera = False\n";
    std::vector<AssetFile> files{{scene.name + ".py", std::move(text), {}}};
    for (const SceneImage& image : scene.images)
        files.push_back(
            {image.name + ".exr",
             {},
             AssetPicture{image.slope_x > 0.0 ? projected_picture(image, projection_of(image)) : panel_picture(image),
                          TexelType::half}});
    return files;
}

} // namespace gonio::asset_detail
