// Godot 4: a scene of lights in physical units, Y up and in metres, with projector textures for the profiles.
//
// An omni light of φ lm emits φ/4π cd, a spot of φ lm emits φ/π cd on its axis, whatever its cone. A spot falls as
// 1 − ((1 − cosθ)/(1 − cos outer))^p, where p is spot_angle_attenuation: linear over the cosine for p = 1, with a hard
// edge for large p. An area light of φ lm has φ/2π cd on its axis, twice that of a Lambertian one of its flux, spread
// over its area (area_normalize_energy); it came with Godot 4.7. With an attenuation of 2, the distance falloff is the
// inverse square times the window of the range. Every light has a range: if the light does not specify one, the window
// takes away at most `window_loss_lx`.
//
// A profile that stays within 60° of its aim is a spot of large p with a projector that is a plane across the aim, −Z
// (up is +Y, right +X). Other profiles are omni lights with a panorama: its first row is −Y and its middle is +Z,
// because Godot's projectors of omni lights are upside down. An image is projected like the former. All are 8-bit and
// sRGB-encoded with a peak of 1, and a spot's projector needs shadows to be on (godotengine/godot, issues 57704 and
// 121615).
//
// A panorama of a sky has +Z in its middle and −X to the right; `background_intensity` is the luminance of a texel
// of 1.
#include <gonio/asset/detail/scene_image.hpp>
#include <gonio/asset/detail/scene_text.hpp>
#include <gonio/bake/engine.hpp>
#include <gonio/color/rgb_space.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace gonio::asset_detail {

namespace {

using std::numbers::pi;

constexpr double edge_power = 64.0; // p of a profile's spot
constexpr double edge_of_light = 0.8; // (1 − cosθ)/(1 − cos outer) up to which there is light: 1 − 0.8^64 = 1 − 6e-7

// Half angle of the spot whose steep edge begins at this angle from its axis.
double widened(double angle) {
    return std::acos(1.0 - (1.0 - std::cos(angle)) / edge_of_light);
}

// Half angle of the spot that contains the profile; nothing if the profile needs an omni light.
std::optional<double> spot_angle(const MeasuredLight& profile) {
    double widest = 1.0;
    const Web& web = profile.web;
    for (std::size_t plane = 0; plane < web.planes_deg().size(); ++plane)
        for (std::size_t k = 0; k < web.gammas_deg().size(); ++k)
            if (web.column(plane)[k] > 1e-3 * profile.peak.value) widest = std::max(widest, web.gammas_deg()[k]);
    if (widest > 60.0) return std::nullopt;
    return widened(widest * pi / 180.0);
}

AssetPicture projector(const SceneImage& image) {
    Image picture = projected_picture(image, square_around_cone(image, widened(cone_of(image))));
    for (float& value : picture.pixels)
        value = static_cast<float>(encode_srgb(static_cast<double>(value)));
    return {std::move(picture), TexelType::uint8};
}

AssetPicture projector(const MeasuredLight& profile) {
    const std::optional<double> angle = spot_angle(profile);
    if (!angle) return engine_picture("godot-omni", profile.web);
    BakeOptions plane = (*find_engine("godot-spot"))->bake;
    plane.chart.turned = glm::dmat3(1.0);
    plane.chart.cone = Radians(2.0 * *angle);
    return baked_picture(profile.web, plane);
}

std::string transform(const Frame& frame) {
    const glm::dvec3 x = y_up(frame.x);
    const glm::dvec3 y = y_up(frame.y);
    const glm::dvec3 z = y_up(frame.z);
    return fmt::format("Transform3D({}, {}, {}, {})", triple({x.x, y.x, z.x}), triple({x.y, y.y, z.y}),
                       triple({x.z, y.z, z.z}), triple(y_up(frame.origin)));
}

std::string node(const SceneLight& light, const SceneContent& scene) {
    const ScaledColor color = scaled(light.color);
    const double reach = reach_of(light);
    std::string type = "OmniLight3D";
    std::string amount;
    const auto omni = [&] {
        amount = fmt::format("light_intensity_lumens = {}\nomni_range = {}\nomni_attenuation = 2.0\n",
                             4.0 * pi * color.factor * light.intensity, reach);
    };
    const auto spot = [&](double outer, double power) {
        type = "SpotLight3D";
        amount = fmt::format("light_intensity_lumens = {}\nspot_range = {}\nspot_attenuation = 2.0\nspot_angle = {}\n"
                             "spot_angle_attenuation = {}\n",
                             pi * color.factor * light.intensity, reach, outer * 180.0 / pi, power);
    };
    switch (light.kind) {
    case LightKind::sun:
        type = "DirectionalLight3D";
        amount = fmt::format("light_intensity_lux = {}\nlight_angular_distance = {}\n", color.factor * light.lux,
                             light.diameter * 180.0 / pi);
        break;
    case LightKind::spot:
        spot(light.outer, 1.0);
        break;
    case LightKind::profile:
        if (const auto angle = spot_angle(scene.profiles[light.profile]))
            spot(*angle, edge_power);
        else
            omni();
        amount += fmt::format("light_projector = ExtResource(\"{}\")\nshadow_enabled = true\n", light.profile + 1);
        break;
    case LightKind::projector:
        spot(widened(cone_of(scene.images[light.image])), edge_power);
        amount += fmt::format("light_projector = ExtResource(\"image_{}\")\nshadow_enabled = true\n", light.image + 1);
        break;
    case LightKind::rect:
        type = "AreaLight3D";
        amount = fmt::format("light_intensity_lumens = {}\narea_size = Vector2({}, {})\narea_range = {}\n"
                             "area_attenuation = 2.0\narea_normalize_energy = true\n",
                             2.0 * pi * color.factor * light.intensity, light.width, light.height, reach);
        break;
    default:
        omni();
        if (light.radius > 0.0) amount += fmt::format("light_size = {}\n", light.radius);
    }
    return fmt::format(
        "\n[node name=\"{}\" type=\"{}\" parent=\".\"]\ntransform = {}\nlight_color = Color({}, {}, {}, 1)\n"
        "light_specular = 1.0\n{}",
        light.name, type, transform(light.frame), encode_srgb(color.rgb.x), encode_srgb(color.rgb.y),
        encode_srgb(color.rgb.z), amount);
}

// North, which is −Z here, is in the middle of the picture: half a turn.
std::string environment(const SceneSky& sky) {
    return fmt::format(
        "\n[ext_resource type=\"Texture2D\" path=\"{0}\" id=\"sky\"]\n"
        "\n[sub_resource type=\"PanoramaSkyMaterial\" id=\"panorama\"]\npanorama = ExtResource(\"sky\")\n"
        "energy_multiplier = 1.0\n"
        "\n[sub_resource type=\"Sky\" id=\"dome\"]\nsky_material = SubResource(\"panorama\")\n"
        "\n[sub_resource type=\"Environment\" id=\"environment\"]\nbackground_mode = 2\n"
        "background_energy_multiplier = 1.0\nbackground_intensity = {1}\nsky = SubResource(\"dome\")\n"
        "sky_rotation = Vector3(0, {2}, 0)\nambient_light_source = 3\nreflected_light_source = 2\n",
        sky.picture, sky.nits_per_unit, pi);
}

} // namespace

std::vector<AssetFile> godot_files(const SceneContent& scene) {
    std::string text = fmt::format(
        "; {}\n; A light without a range of its own ends where this takes away at most {} lx.\n[gd_scene format=3]\n",
        scene.description, window_loss_lx);
    for (std::size_t i = 0; i < scene.profiles.size(); ++i)
        text += fmt::format("\n[ext_resource type=\"Texture2D\" path=\"{}.png\" id=\"{}\"]\n", scene.profiles[i].name,
                            i + 1);
    for (std::size_t i = 0; i < scene.images.size(); ++i)
        text += fmt::format("\n[ext_resource type=\"Texture2D\" path=\"{}.png\" id=\"image_{}\"]\n",
                            scene.images[i].name, i + 1);
    if (scene.sky) text += environment(*scene.sky);
    text += fmt::format("\n[node name=\"{}\" type=\"Node3D\"]\n", scene.single ? "lights" : scene.name);
    for (const SceneLight& light : scene.lights)
        text += node(light, scene);
    if (scene.sky)
        text += fmt::format("\n[node name=\"{}\" type=\"WorldEnvironment\" parent=\".\"]\n"
                            "environment = SubResource(\"environment\")\n",
                            scene.sky->name);
    std::vector<AssetFile> files{{scene.name + ".tscn", std::move(text), {}}};
    for (const MeasuredLight& profile : scene.profiles)
        files.push_back({profile.name + ".png", {}, projector(profile)});
    for (const SceneImage& image : scene.images)
        files.push_back({image.name + ".png", {}, projector(image)});
    return files;
}

} // namespace gonio::asset_detail
