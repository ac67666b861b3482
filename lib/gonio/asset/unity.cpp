// Unity: the portable profiles for HDRP's own importer, cookies for spot and point lights, and a C# script with the
// importer's settings and a menu item that makes the lights.
//
// Left-handed, Y up: a light's +Z is γ = 0, its +Y is C0 and its −X is C90; a cookie's texel of 1 is the peak. Lights
// are in candela, areas in nits and suns in lux, as in HDRP of Unity 6; a tube is a line, in lumens; a spot falls as
// the square of a linear function of the cosine. Unity's own default range is 10 m, so every light gets one. A lat-long
// has +Z in its middle and +X to the right; HDRP's sky shows nits of its texels × its multiplier.
#include <gonio/asset/detail/scene_image.hpp>
#include <gonio/asset/detail/scene_text.hpp>
#include <gonio/bake/engine.hpp>
#include <gonio/web/metrics.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::asset_detail {

namespace {

constexpr const char* cookies = R"cs(
// The spot cookie of a profile is for a spot light of its cone and of the intensity that stands beside it.
class Cookies_{identifier} : AssetPostprocessor
{{
    static readonly string[] Profiles = {{
{profiles}    }};
    static readonly string[] Images = {{ {images} }};

    void OnPreprocessTexture()
    {{
        bool spot = false, point = false;
        foreach (string profile in Profiles)
        {{
            spot |= assetPath.EndsWith("/" + profile + ".spot.png");
            point |= assetPath.EndsWith("/" + profile + ".point.exr");
        }}
        foreach (string image in Images) spot |= assetPath.EndsWith("/" + image + ".cookie.exr");
        if (!point && !spot) return;
        var importer = (TextureImporter)assetImporter;
        importer.textureType = TextureImporterType.Cookie;
        importer.textureShape = point ? TextureImporterShape.TextureCube : TextureImporterShape.Texture2D;
        importer.generateCubemap = TextureImporterGenerateCubemap.Cylindrical;
        importer.sRGBTexture = false;
        importer.alphaSource = TextureImporterAlphaSource.FromGrayScale;
        importer.mipmapEnabled = false;
        importer.wrapMode = TextureWrapMode.Clamp;
        importer.textureCompression = TextureImporterCompression.Uncompressed;
    }}
}}
)cs";

constexpr const char* sky_text = R"cs(
// The picture of the sky as a cube map of floats.
class Sky_{identifier} : AssetPostprocessor
{{
    void OnPreprocessTexture()
    {{
        if (!assetPath.EndsWith("/{picture}")) return;
        var importer = (TextureImporter)assetImporter;
        importer.textureShape = TextureImporterShape.TextureCube;
        importer.generateCubemap = TextureImporterGenerateCubemap.Cylindrical;
        importer.sRGBTexture = false;
        importer.textureCompression = TextureImporterCompression.Uncompressed;
        importer.wrapMode = TextureWrapMode.Clamp;
    }}

    // A global volume with HDRP's sky; the other pipelines have no sky in physical units.
    public static void Add(GameObject root)
    {{
        const string hdrp = "UnityEngine.Rendering.HighDefinition.";
        const string assembly = ", Unity.RenderPipelines.HighDefinition.Runtime";
        var sky = System.Type.GetType(hdrp + "HDRISky" + assembly);
        var environment = System.Type.GetType(hdrp + "VisualEnvironment" + assembly);
        Cubemap picture = null;
        foreach (string guid in AssetDatabase.FindAssets("{stem}"))
            picture = AssetDatabase.LoadAssetAtPath<Cubemap>(AssetDatabase.GUIDToAssetPath(guid)) ?? picture;
        if (sky == null || picture == null)
        {{
            Debug.LogWarning("{name}: the sky needs HDRP and {picture} as a cube map: left out");
            return;
        }}
        var made = new GameObject("{sky}");
        made.transform.SetParent(root.transform, false);
        var volume = made.AddComponent<Volume>();
        volume.isGlobal = true;
        volume.sharedProfile = ScriptableObject.CreateInstance<VolumeProfile>();
        var component = volume.sharedProfile.Add(sky);
        Set(component, "hdriSky", picture);
        Set(component, "skyIntensityMode", 2); // by the multiplier
        Set(component, "multiplier", {intensity}f);
        Set(component, "rotation", 0f);
        Set(volume.sharedProfile.Add(environment), "skyType", 1); // HDRISky
        AssetDatabase.CreateAsset(volume.sharedProfile, "Assets/{name}.sky.asset");
        foreach (VolumeComponent part in volume.sharedProfile.components)
            AssetDatabase.AddObjectToAsset(part, volume.sharedProfile);
        AssetDatabase.SaveAssets();
    }}

    static void Set(VolumeComponent component, string parameter, object value)
    {{
        object holder = component.GetType().GetField(parameter).GetValue(component);
        System.Type held = holder.GetType().GetProperty("value").PropertyType;
        if (held.IsEnum) value = System.Enum.ToObject(held, value);
        holder.GetType().GetMethod("Override", new[] {{ held }}).Invoke(holder, new[] {{ value }});
    }}
}}
)cs";

constexpr const char* maker = R"cs(
static class Lights_{identifier}
{{
    // aim: the light's +Z; up: its +Y. The colour is linear.
    static Light Add(GameObject root, string name, LightType type, Vector3 position, Vector3 aim, Vector3 up,
                     Color color, float intensity, LightUnit unit)
    {{
        var made = new GameObject(name);
        made.transform.SetParent(root.transform, false);
        made.transform.localPosition = position;
        made.transform.localRotation = Quaternion.LookRotation(aim, up);
        var light = made.AddComponent<Light>();
        light.type = type;
        light.color = color.gamma;
        light.lightUnit = unit;
        light.intensity = intensity;
        return light;
    }}

    static Texture Cookie(string name)
    {{
        foreach (string guid in AssetDatabase.FindAssets(name))
            return AssetDatabase.LoadAssetAtPath<Texture>(AssetDatabase.GUIDToAssetPath(guid));
        return null;
    }}

    // The radius that HDRP's shadows and highlights have; the other pipelines have none.
    static void SetRadius(Light light, float radius)
    {{
        var data = System.Type.GetType("UnityEngine.Rendering.HighDefinition.HDAdditionalLightData, "
                                       + "Unity.RenderPipelines.HighDefinition.Runtime");
        if (data == null) return;
        var settings = light.gameObject.GetComponent(data);
        if (settings == null) settings = light.gameObject.AddComponent(data);
        data.GetProperty("shapeRadius")?.SetValue(settings, radius);
    }}

    [MenuItem("GameObject/Light/{name}")]
    static void Make()
    {{
        var root = new GameObject("{name}");
        Light light;
{lights}    }}
}}
)cs";

// A whole number of degrees that covers everything above a hundredth of the peak, as far as a spot light opens.
double cone_deg(const Web& web) {
    double widest = 1.0;
    for (const double c : {0.0, 45.0, 90.0, 135.0})
        if (const auto spread = spread_angle(web, c, 0.01)) widest = std::max(widest, to_degrees(*spread));
    return std::min(std::ceil(widest), 170.0);
}

std::string vector(std::string_view type, const glm::dvec3& v) {
    return fmt::format("new {}({}f)", type, triple(v, "f, "));
}

std::string statement(const SceneLight& light, const SceneContent& scene) {
    const ScaledColor color = scaled(light.color);
    const auto add = [&](std::string_view type, double intensity, std::string_view unit, const glm::dvec3& up) {
        return fmt::format("        light = Add(root, {}, LightType.{}, {},\n            {}, {},\n            {}, {}f, "
                           "LightUnit.{});\n",
                           quoted(light.name), type, vector("Vector3", left_handed_y_up(light.frame.origin)),
                           vector("Vector3", left_handed_y_up(-light.frame.z)), vector("Vector3", left_handed_y_up(up)),
                           vector("Color", color.rgb), color.factor * intensity, unit);
    };
    constexpr double degree = 180.0 / std::numbers::pi;
    const std::string range = fmt::format("        light.range = {}f;\n", reach_of(light));
    switch (light.kind) {
    case LightKind::spot:
        return add("Spot", light.intensity, "Candela", light.frame.y) +
               fmt::format("        light.spotAngle = {}f;\n        light.innerSpotAngle = {}f;\n",
                           2.0 * light.outer * degree, 2.0 * light.inner * degree) +
               range;
    case LightKind::projector: {
        const SceneImage& image = scene.images[light.image];
        const double cone = 2.0 * cone_of(image) * degree;
        return add("Spot", light.intensity, "Candela", light.frame.y) +
               fmt::format("        light.spotAngle = {}f;\n        light.innerSpotAngle = {}f;\n"
                           "        light.cookie = Cookie({});\n",
                           cone, hard_edge * cone, quoted(image.name + ".cookie")) +
               range;
    }
    case LightKind::rect:
        return add("Rectangle", light.nits, "Nits", light.frame.y) +
               fmt::format("        light.areaSize = new Vector2({}f, {}f);\n", light.width, light.height) + range;
    case LightKind::tube: // a line of Φ lm has Φ/2π cd to its side, which a radius does not change
        return add("Tube", 2.0 * std::numbers::pi * light.intensity, "Lumen", light.frame.y) +
               fmt::format("        light.areaSize = new Vector2({}f, {}f);\n", light.width, 2.0 * light.radius) +
               range;
    case LightKind::sun:
        return add("Directional", light.lux, "Lux", light.frame.y);
    case LightKind::profile:
        return add("Point", light.intensity, "Candela", light.frame.x) +
               fmt::format("        light.cookie = Cookie({});\n",
                           quoted(scene.profiles[light.profile].name + ".point")) +
               range;
    default:
        return add("Point", light.intensity, "Candela", light.frame.y) + range +
               (light.radius > 0.0 ? fmt::format("        SetRadius(light, {}f);\n", light.radius) : std::string());
    }
}

} // namespace

std::vector<AssetFile> unity_files(const SceneContent& scene) {
    using namespace fmt::literals;
    std::vector<AssetFile> files;
    std::string profiles;
    for (const MeasuredLight& profile : scene.profiles) {
        const double cone = cone_deg(profile.web);
        BakeOptions spot = (*find_engine("unity-spot"))->bake;
        spot.chart.cone = degrees(cone);
        files.push_back({profile.name + ".ies", profile.portable_ies, {}});
        files.push_back({profile.name + ".spot.png", {}, baked_picture(profile.web, spot)});
        files.push_back({profile.name + ".point.exr", {}, engine_picture("unity-point", profile.web)});
        profiles +=
            fmt::format("        {}, // {} cd, a cone of {} degrees\n", quoted(profile.name), profile.peak.value, cone);
    }
    std::string images;
    for (const SceneImage& image : scene.images) {
        files.push_back(
            {image.name + ".cookie.exr",
             {},
             AssetPicture{projected_picture(image, square_around_cone(image, cone_of(image))), TexelType::half}});
        images += (images.empty() ? "" : ", ") + quoted(image.name);
    }
    std::string lights;
    for (const SceneLight& light : scene.lights)
        lights += statement(light, scene);
    if (scene.sky) lights += fmt::format("        Sky_{}.Add(root);\n", identifier(scene.name));
    const std::string name = identifier(scene.name);
    std::string text =
        fmt::format("// {}\n// Keep in a folder named Editor under Assets. GameObject > Light > {} makes "
                    "the lights, in metres; one without a range of its own ends where this takes away at most {} "
                    "lx.\nusing UnityEditor;\nusing UnityEngine;\nusing "
                    "UnityEngine.Rendering;\n",
                    scene.description, scene.name, window_loss_lx);
    if (!scene.profiles.empty() || !scene.images.empty())
        text += fmt::format(cookies, "identifier"_a = name, "profiles"_a = profiles, "images"_a = images);
    if (scene.sky)
        text += fmt::format(sky_text, "identifier"_a = name, "name"_a = scene.name, "sky"_a = scene.sky->name,
                            "picture"_a = scene.sky->picture, "stem"_a = scene.name + "." + scene.sky->name,
                            "intensity"_a = scene.sky->nits_per_unit);
    text += fmt::format(maker, "identifier"_a = name, "name"_a = scene.name, "lights"_a = lights);
    files.push_back({scene.name + ".cs", std::move(text), {}});
    return files;
}

} // namespace gonio::asset_detail
