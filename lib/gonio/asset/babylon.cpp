// Babylon.js: a module that makes the lights, left-handed and Y up, for PBR materials.
//
// A profile is a SpotLight with a texture that is looked up at u = γ/180° only. Babylon's own .ies loader takes the
// first plane and loses the candela; our texture stores the mean over C, with the peak as the light's intensity.
// Falloff is glTF's: the inverse square with the window of a range; a spot falls as the square of a linear function of
// the cosine. A RectAreaLight is in nits and shines along −Z; it has no rotation, so that a node turns it. A panorama
// has +Z in its middle and +X to the right.
#include <gonio/asset/detail/scene_text.hpp>

#include <fmt/format.h>

#include <span>

namespace gonio::asset_detail {

namespace {

// Eight numbers per line.
std::string number_lines(std::span<const float> numbers) {
    std::string lines;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        lines += fmt::format("{}{},{}", i % 8 == 0 ? "    " : " ", numbers[i], i % 8 == 7 ? "\n" : "");
    if (numbers.size() % 8 != 0) lines += '\n';
    return lines;
}

constexpr const char* imports = R"js(
import { Color3 } from '@babylonjs/core/Maths/math.color.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { Constants } from '@babylonjs/core/Engines/constants.js';
import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js';
import { Light } from '@babylonjs/core/Lights/light.js';
import { PointLight } from '@babylonjs/core/Lights/pointLight.js';
import { SpotLight } from '@babylonjs/core/Lights/spotLight.js';
import { RawTexture } from '@babylonjs/core/Materials/Textures/rawTexture.js';
)js";

constexpr const char* area_imports = R"js(
import { Quaternion } from '@babylonjs/core/Maths/math.vector.js';
import { RectAreaLight } from '@babylonjs/core/Lights/rectAreaLight.js';
import { TransformNode } from '@babylonjs/core/Meshes/transformNode.js';
)js";

// Its highlights need tables that Babylon.js loads from its own server.
constexpr const char* area_text = R"js(
function areaLight(scene, name, position, right, up, back, width, height) {
    const node = new TransformNode(`${name} place`, scene);
    node.position = new Vector3(...position);
    const axes = [right, up, back].map((axis) => new Vector3(...axis));
    node.rotationQuaternion = Quaternion.RotationQuaternionFromAxis(...axes);
    const light = new RectAreaLight(name, Vector3.Zero(), width, height, scene);
    light.parent = node;
    return light;
}
)js";

constexpr const char* helpers = R"js(
function finish(light, mode, intensity, color, range) {
    light.intensityMode = mode;
    light.falloffType = Light.FALLOFF_GLTF;
    light.intensity = intensity;
    light.diffuse = light.specular = new Color3(...color);
    if (range > 0) light.range = range;
    return light;
}

function profileLight(scene, name, position, aim, profile) {
    const light = new SpotLight(name, new Vector3(...position), new Vector3(...aim), Math.PI, 0, scene);
    light.iesProfileTexture = new RawTexture(
        Float32Array.from(profiles[profile]), profiles[profile].length, 1, Constants.TEXTUREFORMAT_R, scene, false,
        false, Constants.TEXTURE_BILINEAR_SAMPLINGMODE, Constants.TEXTURETYPE_FLOAT);
    return light;
}

function spotLight(scene, name, position, aim, inner, outer) {
    const light = new SpotLight(name, new Vector3(...position), new Vector3(...aim), 2 * outer, 0, scene);
    light.innerAngle = 2 * inner;
    return light;
}
)js";

// The cube's faces are about as fine as the panorama.
constexpr const char* sky_text = R"js(
import {{ HDRCubeTexture }} from '@babylonjs/core/Materials/Textures/hdrCubeTexture.js';

// Lights the scene from all around. size: of a face of the cube [pixels].
export function addSky(scene, size = {size}) {{
    const url = new URL('{picture}', import.meta.url).href;
    scene.environmentTexture = new HDRCubeTexture(url, scene, size, false, true, false, true);
    scene.environmentIntensity = {intensity};
    return scene.environmentTexture;
}}
)js";

std::string vector(const glm::dvec3& v) {
    return "[" + triple(v) + "]";
}

std::string entry(const SceneLight& light) {
    const std::string name = quoted(light.name);
    const std::string position = vector(left_handed_y_up(light.frame.origin));
    const std::string aim = vector(left_handed_y_up(-light.frame.z));
    const double range = light.range.value_or(0.0);
    const auto finish = [&](const std::string& made, std::string_view mode, double intensity) {
        return fmt::format("        finish({}, Light.INTENSITYMODE_{}, {}, {}, {}),\n", made, mode, intensity,
                           vector(light.color), range);
    };
    if (light.kind == LightKind::sun)
        return finish(fmt::format("new DirectionalLight({}, new Vector3(...{}), scene)", name, aim), "ILLUMINANCE",
                      light.lux);
    if (light.kind == LightKind::rect)
        // Right is the light's −X: the axes are left-handed.
        return finish(fmt::format("areaLight(scene, {}, {}, {}, {}, {}, {}, {})", name, position,
                                  vector(left_handed_y_up(-light.frame.x)), vector(left_handed_y_up(light.frame.y)),
                                  vector(left_handed_y_up(light.frame.z)), light.width, light.height),
                      "AUTOMATIC", light.nits);
    std::string made = fmt::format("new PointLight({}, new Vector3(...{}), scene)", name, position);
    if (light.kind == LightKind::spot)
        made = fmt::format("spotLight(scene, {}, {}, {}, {}, {})", name, position, aim, light.inner, light.outer);
    if (light.kind == LightKind::profile)
        made = fmt::format("profileLight(scene, {}, {}, {}, {})", name, position, aim, light.profile);
    return finish(made, "LUMINOUSINTENSITY", light.intensity);
}

} // namespace

std::vector<AssetFile> babylon_files(const SceneContent& scene) {
    // A layout and size that work for every web.
    BakeOptions rings;
    rings.layout = Layout::v180;
    rings.width = 180;
    rings.height = 1;
    rings.normalization = Normalization::peak;
    std::string profiles;
    for (const MeasuredLight& profile : scene.profiles)
        profiles += fmt::format("    // {}\n    [\n{}    ],\n", describe(profile),
                                number_lines(baked_picture(profile.web, rings).image.pixels));
    std::string lights;
    bool areas = false;
    for (const SceneLight& light : scene.lights) {
        lights += entry(light);
        areas |= light.kind == LightKind::rect;
    }
    std::string text =
        fmt::format("// {}{}\n"
                    "// Texel i: the mean over C and from i to i + 1 degrees, over the peak.\n"
                    "const profiles = [\n{}];\n{}\n"
                    "// New lights in the scene, Y up and left-handed. Units in a metre: {}.\n"
                    "export function makeLights(scene) {{\n    return [\n{}    ];\n}}\n",
                    scene.description, areas ? std::string(imports) + (area_imports + 1) : imports, profiles,
                    areas ? std::string(helpers) + area_text : helpers, scene.units_per_meter, lights);
    if (scene.sky) {
        using namespace fmt::literals;
        text += fmt::format(sky_text, "picture"_a = scene.sky->picture, "intensity"_a = scene.sky->nits_per_unit,
                            "size"_a = 256);
    }
    return {{scene.name + ".js", std::move(text), {}}};
}

} // namespace gonio::asset_detail
