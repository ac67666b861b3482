// The stage for Radiance: surfaces and the lines that render them.
//
// A plastic reflects the share S without colour, more at grazing angles, and (1 − S) of its colour as a Lambertian
// surface; a metal gives its reflection the colour. Roughness is the root-mean-square slope of facets (G. J. Ward,
// "Measuring and Modeling Anisotropic Reflection", 1992), which α is for narrow lobes. Surfaces are visible from both
// sides unless `-bv-` is given.
#include <gonio/asset/detail/radiance_text.hpp>
#include <gonio/asset/stage_scene.hpp>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace gonio::asset_detail {

namespace {

std::string material(std::string_view kind, std::string_view name, const glm::dvec3& rec709, double specular,
                     double alpha) {
    const glm::dvec3 rgb = glm::clamp(radiance_rgb(rec709), 0.0, 1.0);
    return fmt::format("void {} {}\n0\n0\n5 {} {} {}\n", kind, name, triple(rgb, " "), specular, alpha);
}

// What a plastic of the reflectance f0 needs for the albedo.
glm::dvec3 plastic_color(const glm::dvec3& albedo, double f0) {
    return f0 < 1.0 ? albedo / (1.0 - f0) : glm::dvec3(0.0);
}

std::string plastic(std::string_view name, const glm::dvec3& albedo, double f0, double alpha) {
    return material("plastic", name, plastic_color(albedo, f0), f0, f0 > 0.0 ? alpha : 0.0);
}

std::string text_of(const SceneMaterial& of, std::string_view functions) {
    if (!of.has_lobe()) return plastic(of.name, of.diffuse, 0.0, 0.0);
    const MixedMaterial parts = mixed(of);
    if (parts.metal == 1.0) return material("metal", of.name, parts.metal_f0, 1.0, of.alpha);
    if (parts.metal == 0.0) return plastic(of.name, parts.diffuse, parts.f0, of.alpha);
    return material("metal", of.name + ".metal", parts.metal_f0, 1.0, of.alpha) +
           plastic(of.name + ".rest", parts.diffuse, parts.f0, of.alpha) +
           fmt::format("void mixfunc {0}\n4 {0}.metal {0}.rest share {1}.cal\n0\n1 {2}\n", of.name, functions,
                       parts.metal);
}

struct ShapeText {
    std::string_view material;
    std::string_view name;

    std::string face(const Frame& frame, double half_width, double half_height, std::string_view part) const {
        return fmt::format("{} polygon {}{}\n", material, name, part) +
               radiance_rectangle(frame.origin, half_width * frame.x, half_height * frame.y);
    }
    std::string ball(const glm::dvec3& center, double radius, std::string_view part) const {
        return fmt::format("{} sphere {}{}\n0\n0\n4 {} {}\n", material, name, part, triple(center, " "), radius);
    }
    std::string operator()(const Panel& panel) const {
        return face(panel.frame, 0.5 * panel.width, 0.5 * panel.height, "");
    }
    std::string operator()(const Ball& of) const { return ball(of.center, of.radius, ""); }
    std::string operator()(const Box& box) const {
        const Frame& f = box.frame;
        const glm::dvec3& half = box.half_size;
        const auto side = [&](const glm::dvec3& out, double depth, const glm::dvec3& x, double width,
                              const glm::dvec3& y, double height, std::string_view part) {
            return face({f.origin + depth * out, x, y, out}, width, height, part);
        };
        return side(f.x, half.x, f.y, half.y, f.z, half.z, ".1") + side(-f.x, half.x, f.z, half.z, f.y, half.y, ".2") +
               side(f.y, half.y, f.z, half.z, f.x, half.x, ".3") + side(-f.y, half.y, f.x, half.x, f.z, half.z, ".4") +
               side(f.z, half.z, f.x, half.x, f.y, half.y, ".5") + side(-f.z, half.z, f.y, half.y, f.x, half.x, ".6");
    }
    std::string operator()(const Capsule& capsule) const {
        // Whole spheres: the halves inside the cylinder are not visible.
        const glm::dvec3 half = capsule.half_length * capsule.axis;
        return fmt::format("{} cylinder {}\n0\n0\n7 {}  {}  {}\n", material, name, triple(capsule.center - half, " "),
                           triple(capsule.center + half, " "), capsule.radius) +
               ball(capsule.center - half, capsule.radius, ".end1") +
               ball(capsule.center + half, capsule.radius, ".end2");
    }
};

// Radiance measures the distance between its stored values of indirect light in parts of the whole scene.
int ambient_resolution(const SceneStage& stage) {
    const bool is_endless = std::any_of(stage.surfaces.begin(), stage.surfaces.end(), [](const SceneSurface& surface) {
        const auto* const panel = std::get_if<Panel>(&surface.shape);
        return panel != nullptr && panel->width >= plane_size.value;
    });
    return is_endless ? 20000 : 256;
}

} // namespace

bool radiance_clips(const SceneMaterial& of) {
    const auto is_outside = [](const glm::dvec3& rec709) {
        constexpr double rounding = 1e-9;
        const glm::dvec3 rgb = radiance_rgb(rec709);
        return glm::any(glm::lessThan(rgb, glm::dvec3(-rounding))) ||
               glm::any(glm::greaterThan(rgb, glm::dvec3(1.0 + rounding)));
    };
    if (!of.has_lobe()) return is_outside(of.diffuse);
    const MixedMaterial parts = mixed(of);
    return (parts.metal > 0.0 && is_outside(parts.metal_f0)) ||
           (parts.metal < 1.0 && is_outside(plastic_color(parts.diffuse, parts.f0)));
}

std::string radiance_view(const SceneCamera& camera) {
    const Frame& eye = camera.frame;
    const double tangent = std::tan(0.5 * camera.vertical_fov);
    constexpr double degree = 180.0 / std::numbers::pi;
    return fmt::format("rvu -vtv -vp {} -vd {} -vu {} -vh {} -vv {}\n", triple(eye.origin, " "), triple(-eye.z, " "),
                       triple(eye.y, " "), 2.0 * std::atan(tangent * camera.aspect()) * degree,
                       camera.vertical_fov * degree);
}

std::string radiance_stage(const SceneStage& stage, std::string_view name, bool has_sky) {
    constexpr int most_bounces = 10; // what later ones add is lost in Radiance's noise
    std::string text = fmt::format(
        "# oconv {0}.rad > {0}.oct\n"
        "# rpict -vf {0}.vf -x {1} -y {2} -pa 0{3} -ab {4} -aa 0.1 -ad 2048 -as 512 -ar {5} {0}.oct > {0}.hdr\n",
        name, stage.camera.width, stage.camera.height, stage.shows_backs ? " -bv-" : "",
        std::min(stage.bounces + (has_sky ? 1 : 0), most_bounces), ambient_resolution(stage));
    if (stage.white)
        text += fmt::format("# pfilt -1 -e {0} {1}.hdr > {1}.exposed.hdr\n", 179.0 / stage.white->value, name);
    for (const SceneMaterial& of : stage.materials)
        text += '\n' + text_of(of, name);
    for (const SceneSurface& surface : stage.surfaces)
        text += '\n' + std::visit(ShapeText{stage.materials[surface.material].name, surface.name}, surface.shape);
    return text;
}

} // namespace gonio::asset_detail
