// PlayCanvas: a module that makes the lights, Y up.
//
// A light shines along −Y of its entity. Its diffuse reflection is albedo × intensity, without the 1/π of a Lambertian
// surface: so all amounts are divided by π, and a pixel is a luminance, as its skies and emissive materials have it.
// Its inverse square is 16/(d² + 1) times the window of the range, not 1/d²: the module puts the inverse square itself
// in place of that function. A colour is decoded as c^2.2, after an intensity below 1 has been multiplied in. A spot
// falls as smoothstep over the cosine. A profile is an omni light with a cube of intensities as its cookie, which
// clustered lighting copies into an atlas of 8 bits.
#include <gonio/asset/detail/scene_text.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <set>

namespace gonio::asset_detail {

namespace {

using std::numbers::pi;

constexpr int columns = 181;

// { rows, texels: … } of a profile; one row for an axial light.
std::string table_of(const Web& web, Candelas peak) {
    const int rows = web.stored_symmetry() == Symmetry::axial ? 1 : 360;
    std::vector<double> texels;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            texels.push_back(web.candela(j, i) / peak.value);
    return fmt::format("    {{ rows: {}, texels:\n        '{}' }},\n", rows, texels_in_base64(texels));
}

constexpr const char* light_text = R"js(
// The inverse square with the window of the range, in place of PlayCanvas' 16/(d^2 + 1): for every light of the device
// with LIGHTFALLOFF_INVERSESQUARED.
function useInverseSquare(device) {
    ShaderChunks.get(device, SHADERLANGUAGE_GLSL).set('falloffInvSquaredPS', `
float getFalloffWindow(float lightRadius, vec3 lightDir) {
    float ratio = dot(lightDir, lightDir) / (lightRadius * lightRadius);
    return square(saturate(1.0 - square(ratio)));
}
float getFalloffInvSquared(float lightRadius, vec3 lightDir) {
    return getFalloffWindow(lightRadius, lightDir) / max(dot(lightDir, lightDir), 1e-6);
}
`);
    ShaderChunks.get(device, SHADERLANGUAGE_WGSL).set('falloffInvSquaredPS', `
fn getFalloffWindow(lightRadius: f32, lightDir: vec3f) -> f32 {
    let ratio: f32 = dot(lightDir, lightDir) / (lightRadius * lightRadius);
    return square(saturate(1.0 - square(ratio)));
}
fn getFalloffInvSquared(lightRadius: f32, lightDir: vec3f) -> f32 {
    return getFalloffWindow(lightRadius, lightDir) / max(dot(lightDir, lightDir), 1e-6);
}
`);
}

// x, y and z are the axes of the light, which shines along -y. `amount`: candela or lux, over pi. `unit`: what one of
// them is in `luminance`, which PlayCanvas reads in place of `intensity` if the scene has physical units.
function light(app, name, type, position, x, y, z, amount, unit, color, settings) {
    const entity = new Entity(name, app);
    const intensity = Math.max(amount * Math.max(...color), 1);
    const [r, g, b] = color.map((c) => (Math.max(c, 0) * amount / intensity) ** (1 / 2.2));
    entity.addComponent('light', {
        type, color: new Color(r, g, b), intensity, luminance: intensity * unit,
        falloffMode: LIGHTFALLOFF_INVERSESQUARED, ...settings });
    entity.setPosition(...position);
    const axes = new Mat4();
    axes.data.set([...x, 0, ...y, 0, ...z, 0, 0, 0, 0, 1]);
    entity.setRotation(new Quat().setFromMat4(axes));
    app.root.addChild(entity);
    return entity;
}
)js";

constexpr const char* profile_text = R"js(
// Row j: C = j degrees. Column i: gamma = i degrees. 65535 is the peak.
const columns = {columns};
const profiles = [
{profiles}];

// Half floats of numbers from 0 to 1.
function half(value) {{
    if (value < 2 ** -14) return Math.round(value * 2 ** 24);
    const exponent = Math.floor(Math.log2(value));
    return Math.round((value / 2 ** exponent - 1) * 1024) + 1024 * (exponent + 15);
}}

// The intensities around a light over the peak, as a cube map with `size` texels along an edge.
function cookie(device, {{ rows, texels: base64 }}, size = 256) {{
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const texel = (j, i) => bytes[2 * (j % rows * columns + i)] + 256 * bytes[2 * (j % rows * columns + i) + 1];
    const at = (x, y, z) => {{
        const gamma = Math.atan2(Math.hypot(x, z), -y) * 180 / Math.PI;
        const c = (Math.atan2(-z, x) * 180 / Math.PI + 360) % 360 * rows / 360;
        const [i, j] = [Math.min(Math.floor(gamma), columns - 2), Math.floor(c)];
        const along = (row) => texel(row, i) + (gamma - i) * (texel(row, i + 1) - texel(row, i));
        return (along(j) + (c - j) * (along(j + 1) - along(j))) / 65535;
    }};
    const faces = [(u, v) => [1, -v, -u], (u, v) => [-1, -v, u], (u, v) => [u, 1, v], (u, v) => [u, -1, -v],
        (u, v) => [u, -v, 1], (u, v) => [-u, -v, -1]].map((direction) => {{
        const face = new Uint16Array(size * size);
        for (let row = 0; row < size; row++)
            for (let column = 0; column < size; column++)
                face[row * size + column] = half(at(...direction((2 * column + 1) / size - 1, (2 * row + 1) / size - 1)));
        return face;
    }});
    return new Texture(device, {{ name: 'profile', cubemap: true, width: size, height: size, format: PIXELFORMAT_R16F,
        mipmaps: false, minFilter: FILTER_LINEAR, magFilter: FILTER_LINEAR, levels: [faces] }});
}}
)js";

std::string vector(const glm::dvec3& v) {
    return "[" + triple(v) + "]";
}

std::string entry(const SceneLight& light) {
    std::string type = "omni";
    double amount = light.intensity;
    std::string unit = "4 * Math.PI";
    std::string settings = fmt::format("range: {}", reach_of(light));
    if (light.kind == LightKind::sun) {
        type = "directional";
        amount = light.lux;
        unit = "1";
        settings.clear();
    } else if (light.kind == LightKind::spot) {
        type = "spot";
        unit = fmt::format("{}", 2.0 * pi * (1.0 - 0.5 * (std::cos(light.inner) + std::cos(light.outer))));
        settings +=
            fmt::format(", innerConeAngle: {}, outerConeAngle: {}", light.inner * 180.0 / pi, light.outer * 180.0 / pi);
    } else if (light.kind == LightKind::profile) {
        settings += fmt::format(", cookie: cookies[{}], cookieChannel: 'rrr'", light.profile);
    }
    return fmt::format("light(app, {}, '{}', {}, {}, {}, {}, {}, {}, {}, {{ {} }})", quoted(light.name), type,
                       vector(y_up(light.frame.origin)), vector(y_up(light.frame.x)), vector(y_up(light.frame.z)),
                       vector(y_up(-light.frame.y)), amount / pi, unit, vector(light.color), settings);
}

} // namespace

std::vector<AssetFile> playcanvas_files(const SceneContent& scene) {
    using namespace fmt::literals;
    std::set<std::string> imports{"Color",
                                  "Entity",
                                  "LIGHTFALLOFF_INVERSESQUARED",
                                  "Mat4",
                                  "Quat",
                                  "SHADERLANGUAGE_GLSL",
                                  "SHADERLANGUAGE_WGSL",
                                  "ShaderChunks"};
    std::string helpers = light_text;
    std::string cookies;
    if (!scene.profiles.empty()) {
        imports.insert({"FILTER_LINEAR", "PIXELFORMAT_R16F", "Texture"});
        std::string profiles;
        for (const MeasuredLight& profile : scene.profiles)
            profiles += fmt::format("    // {}\n", describe(profile)) + table_of(profile.web, profile.peak);
        helpers += fmt::format(profile_text, "columns"_a = columns, "profiles"_a = profiles);
        cookies = "    const cookies = profiles.map((profile) => cookie(app.graphicsDevice, profile));\n";
    }
    std::string names;
    for (const std::string& name : imports)
        names += (names.empty() ? "" : ", ") + name;
    std::string list;
    for (const SceneLight& light : scene.lights)
        list += "        " + entry(light) + ",\n";
    return {{scene.name + ".js",
             fmt::format("// {}\nimport {{ {} }} from 'playcanvas';\n{}\n"
                         "// New lights in the scene, as entities. Y up, units in a metre: {}. A light without a range "
                         "of its own ends\n// where this takes away at most {} lx. Call it before materials are drawn: "
                         "it changes the inverse square.\n"
                         "export function makeLights(app) {{\n    useInverseSquare(app.graphicsDevice);\n{}"
                         "    return [\n{}    ];\n}}\n",
                         scene.description, names, helpers, scene.units_per_meter, window_loss_lx, cookies, list),
             {}}};
}

} // namespace gonio::asset_detail
