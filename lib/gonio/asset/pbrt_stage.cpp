// The stage for pbrt-v4: a whole scene with direct light only.
//
// pbrt's camera space is left-handed: +X right, +Y up, +Z forward. Its field of view is that of the shorter side. A
// material without a diffuse part is a conductor of that reflectance at normal incidence. A material with both parts is
// a coated diffuse surface, or a mix of the two if its reflectance has a colour. Roughness is α itself
// (`remaproughness` off).
#include <gonio/asset/detail/scene_text.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace gonio::asset_detail {

namespace {

std::string column(const glm::dvec3& v, int w) {
    return fmt::format("{} {}", triple(v, " "), w);
}

std::string camera_text(const SceneCamera& camera, int bounces, std::string_view picture) {
    const Frame& eye = camera.frame;
    const std::array<glm::dvec3, 3> rows{eye.x, eye.y, -eye.z};
    const auto of_axis = [&](int k) { return glm::dvec3(rows[0][k], rows[1][k], rows[2][k]); };
    const glm::dvec3 moved(-glm::dot(rows[0], eye.origin), -glm::dot(rows[1], eye.origin),
                           -glm::dot(rows[2], eye.origin));
    const double tangent = std::tan(0.5 * camera.vertical_fov) * std::min(camera.aspect(), 1.0);
    return fmt::format("Transform [ {}  {}  {}  {} ]\n"
                       "Camera \"perspective\" \"float fov\" [ {} ]\n"
                       "Film \"rgb\" \"integer xresolution\" [ {} ] \"integer yresolution\" [ {} ]\n"
                       "  \"string filename\" \"{}.exr\"\n"
                       "PixelFilter \"box\" \"float xradius\" [ 0.5 ] \"float yradius\" [ 0.5 ]\n"
                       "Sampler \"zsobol\" \"integer pixelsamples\" [ 1024 ]\n"
                       "Integrator \"path\" \"integer maxdepth\" [ {} ]\n",
                       column(of_axis(0), 0), column(of_axis(1), 0), column(of_axis(2), 0), column(moved, 1),
                       2.0 * std::atan(tangent) * 180.0 / std::numbers::pi, camera.width, camera.height, picture,
                       bounces + 1);
}

std::string named(std::string_view name, std::string_view type, const std::string& rest) {
    return fmt::format("MakeNamedMaterial \"{}\" \"string type\" \"{}\"{}\n", name, type, rest);
}

std::string metal(std::string_view name, const glm::dvec3& f0, double alpha) {
    return named(name, "conductor",
                 fmt::format(R"( "rgb reflectance" [ {} ] "float roughness" [ {} ] "bool remaproughness" false)",
                             triple(f0, " "), alpha));
}

std::string dielectric(std::string_view name, const glm::dvec3& diffuse, double f0, double alpha) {
    const std::string reflectance = fmt::format(R"( "rgb reflectance" [ {} ])", triple(diffuse, " "));
    if (f0 == 0.0) return named(name, "diffuse", reflectance);
    return named(name, "coateddiffuse",
                 fmt::format(R"({} "float eta" [ {} ] "float roughness" [ {} ] "bool remaproughness" false)",
                             reflectance, refractive_index(f0), alpha));
}

std::string material_text(const SceneMaterial& material) {
    const MixedMaterial parts = mixed(material);
    if (!material.has_lobe()) return dielectric(material.name, material.diffuse, 0.0, 1.0);
    if (parts.metal == 1.0) return metal(material.name, parts.metal_f0, material.alpha);
    if (parts.metal == 0.0) return dielectric(material.name, parts.diffuse, parts.f0, material.alpha);
    return dielectric(material.name + ".rest", parts.diffuse, parts.f0, material.alpha) +
           metal(material.name + ".metal", parts.metal_f0, material.alpha) +
           named(material.name, "mix",
                 fmt::format(R"( "string materials" [ "{0}.rest" "{0}.metal" ] "float amount" [ {1} ])", material.name,
                             parts.metal));
}

std::string placed(const Frame& frame) {
    return fmt::format("  ConcatTransform [ {}  {}  {}  {} ]\n", column(frame.x, 0), column(frame.y, 0),
                       column(frame.z, 0), column(frame.origin, 1));
}

std::string sphere(double z, double radius) {
    return fmt::format("  AttributeBegin\n    Translate 0 0 {}\n    Shape \"sphere\" \"float radius\" {}\n"
                       "  AttributeEnd\n",
                       z, radius);
}

struct ShapeText {
    std::string operator()(const Panel& panel) const {
        const double x = 0.5 * panel.width;
        const double y = 0.5 * panel.height;
        return placed(panel.frame) +
               fmt::format("  Shape \"bilinearmesh\" \"point3 P\" [ {0} {1} 0  {2} {1} 0  {0} {3} 0  {2} {3} 0 ]\n", -x,
                           -y, x, y);
    }
    std::string operator()(const Ball& ball) const {
        return placed(frame_of(ball)) + fmt::format("  Shape \"sphere\" \"float radius\" {}\n", ball.radius);
    }
    std::string operator()(const Box& box) const {
        std::string points;
        for (int i = 0; i < 8; ++i)
            points += fmt::format(" {}", triple(box.half_size * glm::dvec3((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1,
                                                                           (i & 4) != 0 ? 1 : -1),
                                                " "));
        return placed(box.frame) +
               fmt::format(
                   "  Shape \"trianglemesh\" \"point3 P\" [{} ]\n    \"integer indices\" [ 0 2 3 0 3 1  4 5 7 4 "
                   "7 6  0 1 5 0 5 4  2 6 7 2 7 3  0 4 6 0 6 2  1 3 7 1 7 5 ]\n",
                   points);
    }
    std::string operator()(const Capsule& capsule) const {
        // Whole spheres: the halves inside the cylinder are not visible.
        return placed(frame_of(capsule)) + sphere(-capsule.half_length, capsule.radius) +
               sphere(capsule.half_length, capsule.radius) +
               fmt::format("  Shape \"cylinder\" \"float radius\" {} \"float zmin\" {} \"float zmax\" {}\n",
                           capsule.radius, -capsule.half_length, capsule.half_length);
    }
};

} // namespace

std::string pbrt_stage(const SceneStage& stage, std::string_view picture) {
    std::string text = camera_text(stage.camera, stage.bounces, picture) + "WorldBegin\n";
    for (const SceneMaterial& material : stage.materials)
        text += material_text(material);
    for (const SceneSurface& surface : stage.surfaces)
        text += fmt::format("AttributeBegin\n  # {}\n  NamedMaterial \"{}\"\n{}AttributeEnd\n", surface.name,
                            stage.materials[surface.material].name, std::visit(ShapeText{}, surface.shape));
    return text;
}

} // namespace gonio::asset_detail
