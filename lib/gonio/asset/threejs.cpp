// three.js: a module that makes the lights, Y up. Profiles are IESSpotLights, which WebGPURenderer draws.
//
// Since r187 an IESSpotLight's texture is looked up at γ, from the middle of the first column to that of the last, and
// at the azimuth, from −180° at the middle of the first row, wrapping around. Seen along the light, azimuth 0 is to the
// right, and 90° is where the camera of its shadow has its up direction, which is therefore C90. So texel (i, j) stores
// the intensity at γ = i°, C = j° − 180°, over the peak. The azimuth is computed from a perspective projection, which
// turns directions behind the light by 180°: above the horizon C = j°. The angle of that projection is the cone's times
// `focus`, which keeps it away from 180°, where it would collapse. Before r187 the renderer used the first row for
// every azimuth.
//
// The map of a SpotLight is a square around its cone, +X to the right and +Y on top, and needs no shadow. Outside of
// the map the light is whole, so that the map must cover all of the cone.
//
// Points and spots are in candela (with a decay of 2), areas in nits, suns in lux; the window of `distance` is the same
// as ours; a spot falls as smoothstep over the cosine. An environment is a panorama with +X in its middle and +Z to the
// right, in nits of its texels × `environmentIntensity`.
#include <gonio/asset/detail/scene_image.hpp>
#include <gonio/asset/detail/scene_text.hpp>

#include <fmt/format.h>

#include <set>

namespace gonio::asset_detail {

namespace {

constexpr int columns = 181;

// { "height": rows, "texels": … } of a profile; one row for an axial light.
std::string texture_of(const Web& web, Candelas peak) {
    const int rows = web.stored_symmetry() == Symmetry::axial ? 1 : 360;
    std::vector<double> texels;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            texels.push_back(web.candela(i > 90 ? j : j - 180.0, i) / peak.value);
    return fmt::format("    {{ height: {}, texels:\n        '{}' }},\n", rows, texels_in_base64(texels));
}

constexpr const char* profile_text = R"js(
// Column i: gamma = i degrees. Row j: C = j - 180 degrees, above the horizon j degrees. 65535 is the peak.
const width = {columns};
const profiles = [
{profiles}];

function makeTexture({{ height, texels: base64 }}) {{
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const texels = new Uint16Array(width * height);
    for (let i = 0; i < texels.length; i++)
        texels[i] = DataUtils.toHalfFloat((bytes[2 * i] + 256 * bytes[2 * i + 1]) / 65535);
    const texture = new DataTexture(texels, width, height, RedFormat, HalfFloatType);
    texture.minFilter = texture.magFilter = LinearFilter;
    texture.wrapT = RepeatWrapping;
    texture.needsUpdate = true;
    return texture;
}}

// For WebGPURenderer. c90: where C90 points, across the aim.
function profileLight(color, candela, range, profile, c90) {{
    const light = new IESSpotLight(color, candela, range);
    light.angle = Math.PI / 2;
    light.shadow.focus = 0.5; // a projection of 90 degrees for the azimuths
    light.iesMap = makeTexture(profiles[profile]);
    light.shadow.camera.up.set(...c90);
    return light;
}}
)js";

// The edge of the cone lies beyond the picture's corners: a soft one keeps the shader's step defined.
constexpr const char* projector_text = R"js(
// up: of the picture, across the aim.
function projectorLight(color, candela, range, angle, picture, up) {
    const light = new SpotLight(color, candela, range, angle, 0.001, 2);
    light.map = new EXRLoader().load(new URL(picture, import.meta.url).href);
    light.shadow.camera.up.set(...up);
    return light;
}
)js";

constexpr const char* place_text = R"js(
function place(light, name, position, aim) {
    light.name = name;
    light.position.set(...position);
    light.target.position.set(...position).add(new Vector3(...aim));
    return light;
}
)js";

// North is -Z here and in the middle of the file, +X in that of three.js: a quarter turn.
constexpr const char* sky_text = R"js(
// Lights the scene from all around: await addSky(scene). `seen`: as its background, too.
export async function addSky(scene, seen = false) {{
    const loader = new EXRLoader().setDataType(FloatType);
    const texture = await loader.loadAsync(new URL('{picture}', import.meta.url).href);
    const {{ data, height }} = texture.image;
    const row = data.length / height;
    for (let start = 0; start < data.length; start += row) {{
        const west = data.slice(start, start + row / 4);
        data.copyWithin(start, start + row / 4, start + row);
        data.set(west, start + 3 * row / 4);
    }}
    texture.mapping = EquirectangularReflectionMapping;
    texture.needsUpdate = true;
    scene.environment = texture;
    scene.environmentIntensity = {intensity};
    if (seen) {{
        scene.background = texture;
        scene.backgroundIntensity = scene.environmentIntensity;
    }}
    return texture;
}}
)js";

std::string vector(const glm::dvec3& v) {
    return "[" + triple(v) + "]";
}

// One light of the list; the names that it needs from three.js are added to `imports`.
std::string entry(const SceneLight& light, const SceneContent& scene, std::set<std::string>& imports) {
    const std::string color = fmt::format("new Color({})", triple(light.color));
    const std::string where =
        fmt::format("{}, {}, {}", quoted(light.name), vector(y_up(light.frame.origin)), vector(y_up(-light.frame.z)));
    const std::string range = light.range ? fmt::format("{}", *light.range) : "0";
    switch (light.kind) {
    case LightKind::spot:
        imports.insert("SpotLight");
        return fmt::format("place(new SpotLight({}, {}, {}, {}, {}, 2), {})", color, light.intensity, range,
                           light.outer, 1.0 - light.inner / light.outer, where);
    case LightKind::profile:
        return fmt::format("place(profileLight({}, {}, {}, {}, {}), {})", color, light.intensity, range, light.profile,
                           vector(y_up(light.frame.y)), where);
    case LightKind::projector: {
        imports.insert("SpotLight");
        const SceneImage& image = scene.images[light.image];
        return fmt::format("place(projectorLight({}, {}, {}, {}, {}, {}), {})", color, light.intensity, range,
                           cone_of(image), quoted(image.name + ".exr"), vector(y_up(light.frame.y)), where);
    }
    case LightKind::rect:
        imports.insert({"RectAreaLight", "Matrix4"});
        return fmt::format("area(new RectAreaLight({}, {}, {}, {}), {}, {}, {}, {}, {})", color, light.nits,
                           light.width, light.height, quoted(light.name), vector(y_up(light.frame.origin)),
                           vector(y_up(light.frame.x)), vector(y_up(light.frame.y)), vector(y_up(light.frame.z)));
    case LightKind::sun:
        imports.insert("DirectionalLight");
        return fmt::format("place(new DirectionalLight({}, {}), {})", color, light.lux, where);
    default:
        imports.insert("PointLight");
        return fmt::format("point(new PointLight({}, {}, {}, 2), {}, {})", color, light.intensity, range,
                           quoted(light.name), vector(y_up(light.frame.origin)));
    }
}

} // namespace

std::vector<AssetFile> threejs_files(const SceneContent& scene) {
    using namespace fmt::literals;
    std::set<std::string> imports{"Color", "Vector3"};
    std::string list;
    bool points = false;
    bool areas = false;
    for (const SceneLight& light : scene.lights) {
        list += "        " + entry(light, scene, imports) + ",\n";
        points |= light.kind == LightKind::point;
        areas |= light.kind == LightKind::rect;
    }
    std::string helpers;
    if (!scene.profiles.empty()) {
        imports.insert({"DataTexture", "DataUtils", "HalfFloatType", "IESSpotLight", "LinearFilter", "RedFormat",
                        "RepeatWrapping"});
        std::string profiles;
        for (const MeasuredLight& profile : scene.profiles)
            profiles += texture_of(profile.web, profile.peak);
        helpers += fmt::format(profile_text, "columns"_a = columns, "profiles"_a = profiles);
    }
    if (!scene.images.empty()) helpers += projector_text;
    helpers += place_text;
    if (points)
        helpers += "\nfunction point(light, name, position) {\n    light.name = name;\n"
                   "    light.position.set(...position);\n    return light;\n}\n";
    if (areas)
        helpers += "\n// Renderers need RectAreaLightTexturesLib (WebGPU) or RectAreaLightUniformsLib for it."
                   "\nfunction area(light, name, position, x, y, z) {\n    light.name = name;\n"
                   "    light.position.set(...position);\n"
                   "    const [right, up, back] = [x, y, z].map((axis) => new Vector3(...axis));\n"
                   "    light.quaternion.setFromRotationMatrix(new Matrix4().makeBasis(right, up, back));\n"
                   "    return light;\n}\n";
    std::string loader;
    std::string sky;
    if (scene.sky || !scene.images.empty()) loader = "import { EXRLoader } from 'three/addons/loaders/EXRLoader.js';\n";
    if (scene.sky) {
        imports.insert({"EquirectangularReflectionMapping", "FloatType"});
        sky = fmt::format(sky_text, "picture"_a = scene.sky->picture, "intensity"_a = scene.sky->nits_per_unit);
    }
    std::string names;
    for (const std::string& name : imports)
        names += (names.empty() ? "" : ", ") + name;
    std::string text =
        fmt::format("// {}\nimport {{ {} }} from 'three/webgpu';\n{}{}\n"
                    "// New lights: add each to the scene, and its target where it has one. Units in a metre: {}.\n"
                    "export function makeLights() {{\n    return [\n{}    ];\n}}\n{}",
                    scene.description, names, loader, helpers, scene.units_per_meter, list, sky);
    std::vector<AssetFile> files{{scene.name + ".js", std::move(text), {}}};
    for (const SceneImage& image : scene.images)
        files.push_back(
            {image.name + ".exr",
             {},
             AssetPicture{projected_picture(image, square_around_cone(image, cone_of(image))), TexelType::half}});
    return files;
}

} // namespace gonio::asset_detail
