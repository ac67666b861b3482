// LuxCore: scene properties (.scn), Z up.
//
// A light with `power` P W and `efficency` (LuxCore's spelling) 1 lm/W emits P lm: a point emits P/4π cd, a mappoint
// that intensity times its map over the map's mean, a sphere P/4π²r² nt. LuxCore reads the profile itself and takes
// only the shape from its candela; with `flipz` its −Z is γ = 0, +X is C0, +Y is C90. A distant light has a luminance
// over a cone of half angle theta, a glowing material has a luminance. Transformations list columns.
// A texture's (0, 0) is the top left corner of its file, whose numbers are linear for a `gamma` of 1.
// An infinite light counts azimuths from its +X in the middle of the left edge towards +Y to the right, which as seen
// from inside is a mirror image: its transformation mirrors it.
#include <gonio/asset/detail/scene_image.hpp>
#include <gonio/asset/detail/scene_text.hpp>

#include <fmt/format.h>

#include <numbers>

namespace gonio::asset_detail {

namespace {

using std::numbers::pi;

std::string transformation(const Frame& frame) {
    return fmt::format("{} 0 {} 0 {} 0 {} 1", triple(frame.x, " "), triple(frame.y, " "), triple(frame.z, " "),
                       triple(frame.origin, " "));
}

// A glowing mesh in the light's frame; `emission` is a colour or the name of a texture.
std::string glowing(const SceneLight& light, const Mesh& mesh, const std::string& emission) {
    const std::string name = identifier(light.name);
    std::string vertices;
    std::string faces;
    for (const glm::dvec3& point : mesh.points)
        vertices += fmt::format(" {}", triple(light.frame.origin + light.frame.to_world(point), " "));
    for (const glm::ivec3& face : mesh.faces)
        faces += fmt::format(" {} {} {}", face.x, face.y, face.z);
    return fmt::format("scene.shapes.{0}.type = \"inlinedmesh\"\n"
                       "scene.shapes.{0}.vertices ={1}\n"
                       "scene.shapes.{0}.faces ={2}\n"
                       "scene.materials.{0}.type = \"matte\"\n"
                       "scene.materials.{0}.kd = 0 0 0\n"
                       "scene.materials.{0}.emission = {3}\n"
                       "scene.materials.{0}.emission.gain = {4} {4} {4}\n"
                       "scene.objects.{0}.shape = \"{0}\"\n"
                       "scene.objects.{0}.material = \"{0}\"\n",
                       name, vertices, faces, emission, light.nits);
}
std::string glowing(const SceneLight& light, const Mesh& mesh) {
    return glowing(light, mesh, triple(light.color, " "));
}

std::string text_of(const SceneLight& light, const SceneContent& scene) {
    const std::string prefix = "scene.lights." + identifier(light.name);
    const auto lamp = [&](std::string_view type, double lumens, const std::string& more) {
        return fmt::format("{0}.type = \"{1}\"\n{0}.color = {2}\n{0}.power = {3}\n{0}.efficency = 1\n{4}", prefix, type,
                           triple(light.color, " "), lumens, more);
    };
    switch (light.kind) {
    case LightKind::profile: {
        const MeasuredLight& profile = scene.profiles[light.profile];
        return lamp("mappoint", profile.flux.value * (light.intensity / profile.peak.value),
                    fmt::format("{0}.iesfile = \"{1}.ies\"\n{0}.flipz = 1\n{0}.map.width = 1024\n{0}.map.height = 512\n"
                                "{0}.transformation = {2}\n",
                                prefix, profile.name, transformation(light.frame)));
    }
    case LightKind::sphere:
        return lamp("sphere", 4.0 * pi * pi * light.radius * light.radius * light.nits,
                    fmt::format("{0}.position = {1}\n{0}.radius = {2}\n", prefix, triple(light.frame.origin, " "),
                                light.radius));
    case LightKind::disk:
        return glowing(light, ellipse_mesh(light.radius, light.radius));
    case LightKind::ellipse:
        return glowing(light, ellipse_mesh(0.5 * light.width, 0.5 * light.height));
    case LightKind::rect:
        return glowing(light, rectangle_mesh(light.width, light.height));
    case LightKind::panel: {
        const std::string name = identifier(light.name);
        const Mesh mesh = rectangle_mesh(light.width, light.height);
        std::string places;
        for (const glm::dvec3& point : mesh.points)
            places += fmt::format(" {} {}", 0.5 - point.x / light.width, 0.5 - point.y / light.height);
        return fmt::format("scene.textures.{0}.type = \"imagemap\"\n"
                           "scene.textures.{0}.file = \"{1}.exr\"\n"
                           "scene.textures.{0}.gamma = 1\n"
                           "scene.textures.{0}.wrap = \"clamp\"\n"
                           "scene.shapes.{0}.uvs ={2}\n",
                           name, scene.images[light.image].name, places) +
               glowing(light, mesh, fmt::format("\"{}\"", name));
    }
    case LightKind::tube:
        return glowing(light, capsule_mesh(light.radius, light.width));
    case LightKind::cylinder:
        return glowing(light, cylinder_mesh(light.radius, light.width));
    case LightKind::sun:
        return fmt::format("{0}.type = \"distant\"\n{0}.color = {1}\n{0}.gain = {2} {2} {2}\n{0}.direction = {3}\n"
                           "{0}.theta = {4}\n",
                           prefix, triple(light.color, " "), light.nits, triple(-light.frame.z, " "),
                           0.5 * light.diameter * 180.0 / pi);
    default:
        return lamp("point", 4.0 * pi * light.intensity,
                    fmt::format("{0}.position = {1}\n", prefix, triple(light.frame.origin, " ")));
    }
}

std::string text_of(const SceneSky& sky) {
    const std::string prefix = "scene.lights." + identifier(sky.name);
    if (sky.picture.empty())
        return fmt::format("{0}.type = \"constantinfinite\"\n{0}.color = {1}\n{0}.gain = {2} {2} {2}\n", prefix,
                           triple(sky.color, " "), sky.nits);
    // The left edge is the south, a quarter from it the west.
    return fmt::format("{0}.type = \"infinite\"\n{0}.file = \"{1}\"\n{0}.gamma = 1\n{0}.gain = {2} {2} {2}\n"
                       "{0}.transformation = 0 -1 0 0 -1 0 0 0 0 0 1 0 0 0 0 1\n",
                       prefix, sky.picture, sky.nits_per_unit);
}

} // namespace

std::vector<AssetFile> luxcore_files(const SceneContent& scene) {
    std::string text = fmt::format("# {}\n", scene.description);
    for (const SceneLight& light : scene.lights)
        text += text_of(light, scene);
    if (scene.sky) text += fmt::format("# {:.6g} lx on the horizontal\n", scene.sky->lux) + text_of(*scene.sky);
    std::vector<AssetFile> files{{scene.name + ".scn", std::move(text), {}}};
    for (const MeasuredLight& profile : scene.profiles)
        files.push_back({profile.name + ".ies", profile.portable_ies, {}});
    for (const SceneImage& image : scene.images)
        files.push_back({image.name + ".exr", {}, AssetPicture{panel_picture(image), TexelType::half}});
    return files;
}

} // namespace gonio::asset_detail
