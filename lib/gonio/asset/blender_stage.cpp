// The stage for Blender: a separate scene with direct light only, as Cycles renders it.
//
// Spheres and capsules are meshes of radius 1 with smooth normals, one for each shape, scaled. A material is the sum of
// a Diffuse BSDF and a Principled BSDF of metallic 1. The lobe of the latter is GGX with the reflectance from its base
// colour to 1 at grazing; it has no diffuse part.
#include <gonio/asset/detail/scene_text.hpp>

#include <fmt/format.h>

#include <cmath>

namespace gonio::asset_detail {

namespace {

constexpr const char* scene_text = R"python(
scene = bpy.data.scenes.new({name})
bpy.context.window.scene = scene
)python";

constexpr const char* helpers = R"python(

def stage_material(name, diffuse, f0, roughness, one_sided):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes = material.node_tree.nodes
    links = material.node_tree.links
    nodes.clear()
    parts = []
    if any(diffuse) or not any(f0):
        part = nodes.new("ShaderNodeBsdfDiffuse")
        part.inputs["Color"].default_value = diffuse + (1.0,)
        part.inputs["Roughness"].default_value = 0.0
        parts.append(part.outputs[0])
    if any(f0):
        part = nodes.new("ShaderNodeBsdfPrincipled")
        part.distribution = "GGX"
        part.inputs["Base Color"].default_value = f0 + (1.0,)
        part.inputs["Metallic"].default_value = 1.0
        part.inputs["Roughness"].default_value = roughness
        parts.append(part.outputs[0])
    if len(parts) == 2:
        both = nodes.new("ShaderNodeAddShader")
        links.new(parts[0], both.inputs[0])
        links.new(parts[1], both.inputs[1])
        parts = [both.outputs[0]]
    if one_sided:  # the camera looks through the backs of sheets
        back = nodes.new("ShaderNodeMath")
        back.operation = "MULTIPLY"
        links.new(nodes.new("ShaderNodeNewGeometry").outputs["Backfacing"], back.inputs[0])
        links.new(nodes.new("ShaderNodeLightPath").outputs["Is Camera Ray"], back.inputs[1])
        seen = nodes.new("ShaderNodeMixShader")
        links.new(back.outputs[0], seen.inputs[0])
        links.new(parts[0], seen.inputs[1])
        links.new(nodes.new("ShaderNodeBsdfTransparent").outputs[0], seen.inputs[2])
        parts = [seen.outputs[0]]
    links.new(parts[0], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return material


def stage_mesh(name, points, faces, smooth):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], faces)
    mesh.polygons.foreach_set("use_smooth", [smooth] * len(faces))
    mesh.materials.append(None)  # each object has its own
    return mesh


def round_mesh(name, half_length, around=256):
    """A capsule along Z of radius 1, a ball without length; faces lie at most 1 - cos(pi / around) inside."""
    rings = [math.pi * k / around * 2.0 for k in range(1, around // 4 + 1)]
    rings = [(half_length + math.cos(a), math.sin(a)) for a in rings]
    if half_length > 0.0:
        rings += [(-z, r) for z, r in reversed(rings)]
    else:
        rings += [(-z, r) for z, r in reversed(rings[:-1])]
    points = [(0.0, 0.0, half_length + 1.0)]
    for z, r in rings:
        turns = [2.0 * math.pi * i / around for i in range(around)]
        points += [(r * math.cos(turn), r * math.sin(turn), z) for turn in turns]
    points.append((0.0, 0.0, -half_length - 1.0))
    faces = [(0, 1 + i, 1 + (i + 1) % around) for i in range(around)]
    for ring in range(len(rings) - 1):
        row = 1 + ring * around
        for i in range(around):
            j = (i + 1) % around
            faces.append((row + i, row + around + i, row + around + j, row + j))
    row = 1 + (len(rings) - 1) * around
    faces += [(len(points) - 1, row + (i + 1) % around, row + i) for i in range(around)]
    return stage_mesh(name, points, faces, True)


def show(name, mesh, material, position, x, y, z):
    shown = place(name, mesh, position, x, y, z)
    shown.material_slots[0].link = "OBJECT"
    shown.material_slots[0].material = material


sheet = stage_mesh(
    "sheet", [(-0.5, -0.5, 0.0), (0.5, -0.5, 0.0), (0.5, 0.5, 0.0), (-0.5, 0.5, 0.0)], [(0, 1, 2, 3)], False
)
box = stage_mesh(
    "box",
    [(x, y, z) for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)],
    [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)],
    False,
)
ball = round_mesh("ball", 0.0)
)python";

constexpr const char* settings = R"python(
for light in scene.collection.objects:
    if light.type == "LIGHT":
        light.visible_camera = True  # Blender hides new lights

eye = bpy.data.cameras.new("camera")
eye.sensor_fit = "VERTICAL"
eye.angle = {fov}
eye.clip_start = 0.01
eye.clip_end = 10000.0
scene.camera = place("camera", eye, {position}, {x}, {y}, {z})
scene.world = bpy.data.worlds.new("dark")
scene.world.color = (0.0, 0.0, 0.0)
scene.render.engine = "CYCLES"
scene.cycles.samples = 1024
scene.cycles.use_adaptive_sampling = False
scene.cycles.use_denoising = False
scene.cycles.max_bounces = {bounces}
scene.cycles.diffuse_bounces = {bounces}
scene.cycles.glossy_bounces = {bounces}
scene.cycles.pixel_filter_type = "BOX"
scene.render.resolution_x = {width}
scene.render.resolution_y = {height}
scene.render.resolution_percentage = 100
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
scene.view_settings.view_transform = "Standard"
)python";

std::string tuple(const glm::dvec3& v) {
    return "(" + triple(v) + ")";
}

// The arguments of show() except the name.
struct Shown {
    std::string material;

    std::string operator()(const Panel& panel) const {
        return text("sheet", panel.frame, {panel.width, panel.height, 1.0});
    }
    std::string operator()(const Ball& ball) const { return text("ball", frame_of(ball), glm::dvec3(ball.radius)); }
    std::string operator()(const Box& box) const { return text("box", box.frame, box.half_size); }
    std::string operator()(const Capsule& capsule) const {
        return text(fmt::format(R"(round_mesh("capsule", {}))", capsule.half_length / capsule.radius),
                    frame_of(capsule), glm::dvec3(capsule.radius));
    }

    std::string text(std::string_view mesh, const Frame& frame, const glm::dvec3& size) const {
        return fmt::format("{}, {}, {}, {}, {}, {}", mesh, material, tuple(frame.origin), tuple(size.x * frame.x),
                           tuple(size.y * frame.y), tuple(size.z * frame.z));
    }
};

} // namespace

std::string blender_stage_start(const SceneContent& scene) {
    using namespace fmt::literals;
    return fmt::format(scene_text, "name"_a = quoted(scene.name));
}

std::string blender_stage(const SceneStage& stage, double lumens_per_watt) {
    using namespace fmt::literals;
    std::string text = helpers;
    text += "\nmaterials = [\n";
    for (const SceneMaterial& material : stage.materials)
        text += fmt::format("    stage_material({}, {}, {}, {}, {}),\n", quoted(material.name), tuple(material.diffuse),
                            tuple(material.f0), std::sqrt(material.alpha), stage.shows_backs ? "True" : "False");
    text += "]\n";
    for (const SceneSurface& surface : stage.surfaces)
        text += fmt::format("show({}, {})\n", quoted(surface.name),
                            std::visit(Shown{fmt::format("materials[{}]", surface.material)}, surface.shape));
    const Frame& eye = stage.camera.frame;
    text += fmt::format(settings, "fov"_a = stage.camera.vertical_fov, "position"_a = tuple(eye.origin),
                        "x"_a = tuple(eye.x), "y"_a = tuple(eye.y), "z"_a = tuple(eye.z), "bounces"_a = stage.bounces,
                        "width"_a = stage.camera.width, "height"_a = stage.camera.height);
    if (stage.white)
        text += fmt::format("scene.view_settings.exposure = {}\n", std::log2(lumens_per_watt / stage.white->value));
    return text;
}

} // namespace gonio::asset_detail
