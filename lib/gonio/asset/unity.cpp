// Unity: the portable profile for HDRP's own importer, and cookies for spot and point lights with the importer's
// settings as a C# script. A light's +Z is γ = 0, its +Y is C0 and its −X is C90; a cookie's texel of 1 is the peak.
#include <gonio/asset/detail/target_files.hpp>
#include <gonio/bake/engine.hpp>
#include <gonio/web/metrics.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gonio::asset_detail {

namespace {

constexpr const char* script = R"cs(// {description}
// Keep in a folder named Editor under Assets: {name}.spot.png and {name}.point.exr are then imported as cookies.
// Give the light {peak} cd; {name}.spot.png is for a spot light of {cone} degrees. Turned by Euler angles (90, 90, 0)
// it shines down, C0 along +X.
using UnityEditor;
using UnityEngine;

class Cookies_{identifier} : AssetPostprocessor
{{
    void OnPreprocessTexture()
    {{
        bool point = assetPath.EndsWith("/{name}.point.exr");
        if (!point && !assetPath.EndsWith("/{name}.spot.png")) return;
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

// A whole number of degrees that holds what is above a hundredth of the peak, as far as a spot light opens.
double cone_deg(const Web& web) {
    double widest = 1.0;
    for (const double c : {0.0, 45.0, 90.0, 135.0})
        if (const auto spread = spread_angle(web, c, 0.01)) widest = std::max(widest, to_degrees(*spread));
    return std::min(std::ceil(widest), 170.0);
}

} // namespace

std::vector<AssetFile> unity_files(const MeasuredLight& light) {
    using namespace fmt::literals;
    const double cone = cone_deg(light.web);
    AssetTexture spot{(*find_engine("unity-spot"))->bake};
    spot.bake.chart.cone = degrees(cone);
    spot.bake.threads = 1;
    AssetTexture point{(*find_engine("unity-point"))->bake};
    point.bake.threads = 1;
    std::string identifier = light.name;
    std::replace(identifier.begin(), identifier.end(), '-', '_');
    std::string text = fmt::format(script, "description"_a = describe(light), "name"_a = light.name,
                                   "identifier"_a = identifier, "peak"_a = light.peak.value, "cone"_a = cone);
    return {{light.name + ".ies", light.portable_ies, {}},
            {light.name + ".spot.png", {}, spot},
            {light.name + ".point.exr", {}, point},
            {light.name + ".cs", std::move(text), {}}};
}

} // namespace gonio::asset_detail
