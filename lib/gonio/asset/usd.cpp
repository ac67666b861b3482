// OpenUSD: UsdLux of 24.08, luminances in nits, no light normalised.
//
// On request with the schemas that the proposal "physical lighting" adds to it: lumens of area lights (and of those
// that are treated as points), lux of distant lights and domes. A program that knows them takes these, whatever
// intensity, exposure and the luminance of the colour are; the others take the intensity, which means the same light.
//
// A light that emits from a point is a sphere of 1 m² projected area with treatAsPoint, so that a luminance of 1 nt
// emits 1 cd, which a profile scales and a cone cuts. A dome's texture has +Y of the dome as its pole and +Z in its
// middle, with −X to the right (the lat-long of OpenEXR), wherever the stage's up axis points. The cone's softness is
// the share of the cone in which the intensity falls, smoothly over the angle. angleScale is never authored, because
// its formulas differ between renderers. A rectangle's texture has its first row and column at (+X, +Y), so that it is
// upright for a viewer in front.
#include <gonio/asset/detail/scene_image.hpp>
#include <gonio/asset/detail/scene_text.hpp>
#include <gonio/light/lobe.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

namespace gonio::asset_detail {

namespace {

using std::numbers::pi;

struct Prim {
    std::string type = "SphereLight";
    double nits = 0.0;
    std::string inputs; // further lines
    bool shaped = false;
    double stretch_y = 1.0; // of its transform
    std::optional<double> lumens;
};

// The flux of a surface of an area in the scene's units.
double lumens_of(double nits, double area, const SceneContent& scene) {
    return pi * area * nits / (scene.units_per_meter * scene.units_per_meter);
}

Prim as_point(const SceneLight& light, double units_per_meter) {
    Prim prim;
    prim.nits = light.intensity / (units_per_meter * units_per_meter);
    prim.lumens = 4.0 * pi * prim.nits;
    prim.inputs = fmt::format("        float inputs:radius = {}\n        bool treatAsPoint = 1\n",
                              std::sqrt(std::numbers::inv_pi) * units_per_meter);
    return prim;
}

Prim prim_of(const SceneLight& light, const SceneContent& scene) {
    Prim prim;
    prim.nits = light.nits;
    switch (light.kind) {
    case LightKind::projector: // the target holds none
    case LightKind::point:
        return as_point(light, scene.units_per_meter);
    case LightKind::spot:
        prim = as_point(light, scene.units_per_meter);
        prim.shaped = true;
        prim.lumens =
            prim.nits *
            lobe_solid_angle(SpotShape{Radians(light.outer), Radians(light.inner), Falloff::smoothstep_angle, {}, {}})
                .value;
        prim.inputs += fmt::format("        float inputs:shaping:cone:angle = {}\n"
                                   "        float inputs:shaping:cone:softness = {}\n",
                                   light.outer * 180.0 / pi,
                                   light.inner >= hard_edge * light.outer ? 0.0 : 1.0 - light.inner / light.outer);
        return prim;
    case LightKind::profile:
        prim = as_point(light, scene.units_per_meter);
        prim.nits = 1.0; // the profile gives the candela
        prim.lumens = scene.profiles[light.profile].flux.value;
        prim.shaped = true;
        prim.inputs += fmt::format("        asset inputs:shaping:ies:file = @./{}.ies@\n"
                                   "        bool inputs:shaping:ies:normalize = 0\n",
                                   scene.profiles[light.profile].name);
        return prim;
    case LightKind::sphere:
        prim.lumens = lumens_of(prim.nits, 4.0 * pi * light.radius * light.radius, scene);
        prim.inputs = fmt::format("        float inputs:radius = {}\n", light.radius);
        return prim;
    case LightKind::disk:
        prim.type = "DiskLight";
        prim.lumens = lumens_of(prim.nits, pi * light.radius * light.radius, scene);
        prim.inputs = fmt::format("        float inputs:radius = {}\n", light.radius);
        return prim;
    case LightKind::ellipse:
        // A disk stretched by its transform: a scale changes the size but not the luminance.
        prim.type = "DiskLight";
        prim.lumens = lumens_of(prim.nits, 0.25 * pi * light.width * light.height, scene);
        prim.inputs = fmt::format("        float inputs:radius = {}\n", 0.5 * light.width);
        prim.stretch_y = light.height / light.width;
        return prim;
    case LightKind::rect:
    case LightKind::panel:
        prim.type = "RectLight";
        prim.inputs = fmt::format("        float inputs:width = {}\n        float inputs:height = {}\n", light.width,
                                  light.height);
        if (light.kind == LightKind::rect) prim.lumens = lumens_of(prim.nits, light.width * light.height, scene);
        if (light.kind == LightKind::panel)
            prim.inputs +=
                fmt::format("        asset inputs:texture:file = @./{}.exr@\n", scene.images[light.image].name);
        return prim;
    case LightKind::tube: // is written as a cylinder
    case LightKind::cylinder:
        prim.type = "CylinderLight";
        prim.lumens = lumens_of(prim.nits, 2.0 * pi * light.radius * light.width, scene);
        prim.inputs = fmt::format("        float inputs:radius = {}\n        float inputs:length = {}\n", light.radius,
                                  light.width);
        return prim;
    case LightKind::sun:
        prim.type = "DistantLight";
        prim.inputs = fmt::format("        float inputs:angle = {}\n", light.diameter * 180.0 / pi);
        return prim;
    }
    return prim;
}

std::string row(const glm::dvec3& v, int w) {
    return fmt::format("({}, {})", triple(v), w);
}

// The colour is that of a white times the prim's own, of which only the chromaticity counts.
std::string physical_text(std::string_view what, double amount) {
    return fmt::format("        float photometric:{} = {}\n        uniform token physical:illuminant = \"white\"\n",
                       what, amount);
}

std::string text_of(const SceneLight& light, const SceneContent& scene) {
    const Prim prim = prim_of(light, scene);
    std::string text = fmt::format("    def {} \"{}\" (\n", prim.type, identifier(light.name));
    std::string schemas = prim.shaped ? "\"ShapingAPI\"" : "";
    std::string physical;
    if (scene.photometric && (prim.lumens || light.kind == LightKind::sun)) {
        const bool is_sun = light.kind == LightKind::sun;
        schemas += fmt::format("{}\"Photometric{}LightAPI\"", schemas.empty() ? "" : ", ", is_sun ? "Distant" : "Area");
        physical = physical_text(is_sun ? "illuminance" : "power", is_sun ? light.lux : *prim.lumens);
    }
    if (!schemas.empty()) text += fmt::format("        prepend apiSchemas = [{}]\n", schemas);
    if (light.kind == LightKind::profile)
        text +=
            fmt::format("        customData = {{\n            double flux_lm = {}\n            double peak_cd = {}\n"
                        "        }}\n",
                        scene.profiles[light.profile].flux.value, scene.profiles[light.profile].peak.value);
    return text + fmt::format("    )\n"
                              "    {{\n"
                              "        color3f inputs:color = ({})\n"
                              "        float inputs:intensity = {}\n"
                              "        bool inputs:normalize = 0\n"
                              "{}{}"
                              "        matrix4d xformOp:transform = ( {}, {}, {}, {} )\n"
                              "        uniform token[] xformOpOrder = [\"xformOp:transform\"]\n"
                              "    }}\n",
                              triple(light.color), prim.nits, prim.inputs, physical, row(light.frame.x, 0),
                              row(prim.stretch_y * light.frame.y, 0), row(light.frame.z, 0),
                              row(light.frame.origin, 1));
}

std::string text_of(const SceneSky& sky, bool photometric) {
    const std::string texture = sky.picture.empty() ? std::string()
                                                    : fmt::format("        asset inputs:texture:file = @./{}@\n"
                                                                  "        token inputs:texture:format = \"latlong\"\n",
                                                                  sky.picture);
    // The pole becomes +Z, the middle +Y, the right +X.
    return fmt::format(
        "    def DomeLight \"{}\" (\n"
        "{}"
        "        customData = {{\n            double horizontal_lx = {}\n        }}\n"
        "    )\n"
        "    {{\n"
        "        color3f inputs:color = ({})\n"
        "        float inputs:intensity = {}\n"
        "{}{}"
        "        matrix4d xformOp:transform = ( (-1, 0, 0, 0), (0, 0, 1, 0), (0, 1, 0, 0), (0, 0, 0, 1) )\n"
        "        uniform token[] xformOpOrder = [\"xformOp:transform\"]\n"
        "    }}\n",
        identifier(sky.name), photometric ? "        prepend apiSchemas = [\"PhotometricDomeLightAPI\"]\n" : "",
        sky.lux, triple(sky.color), sky.picture.empty() ? sky.nits : sky.nits_per_unit, texture,
        photometric ? physical_text("illuminance", sky.lux) : std::string());
}

} // namespace

std::vector<AssetFile> usd_files(const SceneContent& scene) {
    std::string text = fmt::format("#usda 1.0\n"
                                   "(\n"
                                   "    defaultPrim = \"{0}\"\n"
                                   "    doc = {1}\n"
                                   "    metersPerUnit = {2}\n"
                                   "{3}    upAxis = \"Z\"\n"
                                   ")\n"
                                   "\n"
                                   "def Xform \"{0}\"\n"
                                   "{{\n",
                                   identifier(scene.name), quoted(scene.description), 1.0 / scene.units_per_meter,
                                   scene.stage ? "    renderSettingsPrimPath = \"/Render/settings\"\n" : "");
    if (scene.stage) text += usd_stage(*scene.stage, identifier(scene.name));
    for (const SceneLight& light : scene.lights)
        text += text_of(light, scene);
    if (scene.sky) text += text_of(*scene.sky, scene.photometric);
    text += "}\n";
    if (scene.stage) text += usd_render_settings(*scene.stage, identifier(scene.name));
    std::vector<AssetFile> files{{scene.name + ".usda", std::move(text), {}}};
    for (const MeasuredLight& profile : scene.profiles)
        files.push_back({profile.name + ".ies", profile.portable_ies, {}});
    for (const SceneImage& image : scene.images)
        files.push_back({image.name + ".exr", {}, AssetPicture{panel_picture(image), TexelType::half}});
    return files;
}

} // namespace gonio::asset_detail
