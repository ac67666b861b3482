// pbrt-v4: lights with photometric numbers (`scale` in candela and nits, `illuminance` in lux, `power` in lumens).
//
// A profile is a goniometric light with an equal-area image (P. Clarberg, "Fast Equal-Area Mapping of the (Hemi)Sphere
// using SIMD", 2008, turned for octahedral maps). pbrt looks up a square image of one channel, Y up, at
// EqualAreaSphereToSquare of the light's direction with y and z swapped: the image's middle is +Y, its right edge +X,
// its lower edge +Z. The image is baked with the nadir in the middle, C0 to the right and C90 below, and turned by −90°
// about X. pbrt scales it to `power`, which is exact because the texels have equal solid angles. Spots fall as
// smoothstep over the cosine.
//
// A projection light emits I = `scale` × texel along +Z, without the cosine of a real projector; its picture has +X to
// the right and +Y on top, `fov` is the full angle of the shorter side, and the nearest texel is looked up. An area
// light takes a picture in the place of `L`: P00 of its patch is the bottom left corner, P10 the bottom right one.
//
// An infinite light looks its square up without that swap: the middle is +Z, the right +X, below +Y. A pixel of 1 at
// `scale` 1 is 1 nt.
#include <gonio/asset/detail/scene_image.hpp>
#include <gonio/asset/detail/scene_text.hpp>
#include <gonio/bake/engine.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::asset_detail {

namespace {

std::string area(const SceneLight& light, std::string_view shapes) {
    return fmt::format("  AreaLightSource \"diffuse\" \"rgb L\" [ {} ] \"float scale\" [ {} ]\n{}",
                       triple(light.color, " "), light.nits, shapes);
}

std::string ball(double x, double radius) {
    return fmt::format("  AttributeBegin\n    Translate {} 0 0\n    Shape \"sphere\" \"float radius\" {}\n"
                       "  AttributeEnd\n",
                       x, radius);
}

// Turns the axis to X for what follows.
std::string pbrt_side(const SceneLight& light) {
    return fmt::format("  Rotate 90 0 1 0\n"
                       "  Shape \"cylinder\" \"float radius\" {} \"float zmin\" {} \"float zmax\" {}\n",
                       light.radius, -0.5 * light.width, 0.5 * light.width);
}

std::string triangles(const Mesh& mesh) {
    std::string indices;
    for (const glm::ivec3& face : mesh.faces)
        indices += fmt::format(" {} {} {}", face.x, face.y, face.z);
    std::string points;
    for (const glm::dvec3& point : mesh.points)
        points += " " + triple(point, " ");
    return fmt::format("  Shape \"trianglemesh\" \"integer indices\" [{} ]\n    \"point3 P\" [{} ]\n", indices, points);
}

std::string body(const SceneLight& light, const SceneContent& scene) {
    const std::string color = fmt::format("\"rgb I\" [ {} ]", triple(light.color, " "));
    constexpr double degree = 180.0 / std::numbers::pi;
    switch (light.kind) {
    case LightKind::point:
        return fmt::format("  LightSource \"point\" {} \"float scale\" [ {} ]\n", color, light.intensity);
    case LightKind::spot:
        return fmt::format("  LightSource \"spot\" {} \"float scale\" [ {} ]\n"
                           "    \"point3 from\" [ 0 0 0 ] \"point3 to\" [ 0 0 -1 ]\n"
                           "    \"float coneangle\" [ {} ] \"float conedeltaangle\" [ {} ]\n",
                           color, light.intensity, light.outer * degree, (light.outer - light.inner) * degree);
    case LightKind::profile: {
        const MeasuredLight& profile = scene.profiles[light.profile];
        return fmt::format("  Rotate -90 1 0 0\n"
                           "  LightSource \"goniometric\"\n"
                           "    \"string filename\" \"{}.exr\"\n"
                           "    {}\n"
                           "    \"float power\" [ {} ]\n",
                           profile.name, color, profile.flux.value * (light.intensity / profile.peak.value));
    }
    case LightKind::projector: {
        const SceneImage& image = scene.images[light.image];
        return fmt::format("  Scale 1 1 -1\n"
                           "  LightSource \"projection\" \"string filename\" \"{}.exr\"\n"
                           "    \"float scale\" [ {} ] \"float fov\" [ {} ]\n",
                           image.name, light.intensity,
                           2.0 * std::atan(std::min(image.slope_x, image.slope_y)) * degree);
    }
    case LightKind::sphere:
        return area(light, ball(0.0, light.radius));
    case LightKind::disk: // its normal is +Z
        return area(light, fmt::format("  Rotate 180 1 0 0\n  Shape \"disk\" \"float radius\" {}\n", light.radius));
    case LightKind::ellipse: // of triangles: pbrt samples a stretched disk by the area that it had before
        return area(light, triangles(ellipse_mesh(0.5 * light.width, 0.5 * light.height)));
    case LightKind::rect: {
        // Its normal is the cross product of the first edge and the second: +Y × +X.
        const double x = 0.5 * light.width;
        const double y = 0.5 * light.height;
        return area(light, fmt::format("  Shape \"bilinearmesh\" \"point3 P\" [ {} {} 0  {} {} 0  {} {} 0  {} {} 0 ]\n",
                                       -x, -y, -x, y, x, -y, x, y));
    }
    case LightKind::panel: {
        const double x = 0.5 * light.width;
        const double y = 0.5 * light.height;
        return fmt::format("  AreaLightSource \"diffuse\" \"string filename\" \"{}.exr\" \"float scale\" [ {} ]\n"
                           "  Shape \"bilinearmesh\" \"point3 P\" [ {} {} 0  {} {} 0  {} {} 0  {} {} 0 ]\n",
                           scene.images[light.image].name, light.nits, x, -y, -x, -y, x, y, -x, y);
    }
    case LightKind::tube:
        // Whole spheres: the halves inside the cylinder only light its inside.
        return area(light,
                    ball(-0.5 * light.width, light.radius) + ball(0.5 * light.width, light.radius) + pbrt_side(light));
    case LightKind::cylinder:
        return area(light, pbrt_side(light));
    case LightKind::sun:
        return fmt::format("  LightSource \"distant\" \"rgb L\" [ {} ] \"float illuminance\" [ {} ]\n"
                           "    \"point3 from\" [ 0 0 0 ] \"point3 to\" [ 0 0 -1 ]\n",
                           triple(light.color, " "), light.lux);
    }
    return {};
}

std::string text_of(const SceneSky& sky) {
    const std::string light =
        sky.picture.empty()
            ? fmt::format(R"("rgb L" [ {} ] "float scale" [ {} ])", triple(sky.color, " "), sky.nits)
            : fmt::format(R"("string filename" "{}" "float scale" [ {} ])", sky.picture, sky.nits_per_unit);
    return fmt::format("AttributeBegin\n  # {}: {:.6g} lx on the horizontal\n  LightSource \"infinite\" {}\n"
                       "AttributeEnd\n",
                       sky.name, sky.lux, light);
}

} // namespace

std::vector<AssetFile> pbrt_files(const SceneContent& scene) {
    std::string text = fmt::format("# {}\n", scene.description);
    if (scene.single) text += "# The beam goes along -Z, C0 along +X, C90 along +Y.\n";
    if (scene.stage) text += pbrt_stage(*scene.stage, scene.name);
    for (const SceneLight& light : scene.lights) {
        text += "AttributeBegin\n";
        if (!scene.single)
            text += fmt::format("  # {}\n  ConcatTransform [ {} 0  {} 0  {} 0  {} 1 ]\n", light.name,
                                triple(light.frame.x, " "), triple(light.frame.y, " "), triple(light.frame.z, " "),
                                triple(light.frame.origin, " "));
        text += body(light, scene) + "AttributeEnd\n";
    }
    if (scene.sky) text += text_of(*scene.sky);
    std::vector<AssetFile> files{{scene.name + ".pbrt", std::move(text), {}}};
    for (const MeasuredLight& profile : scene.profiles)
        files.push_back({profile.name + ".exr", {}, engine_picture("pbrt-v4", profile.web)});
    constexpr int nearest = 1024; // texels of a side, because none are mixed
    for (const SceneImage& image : scene.images)
        files.push_back({image.name + ".exr",
                         {},
                         AssetPicture{image.slope_x > 0.0 ? projected_picture(image, square_texels(image, nearest))
                                                          : panel_picture(image),
                                      TexelType::half}});
    return files;
}

} // namespace gonio::asset_detail
