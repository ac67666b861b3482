// The stage for Mitsuba 3: sensor, integrator for direct light only, materials, shapes.
//
// Its sensor looks along +Z, +Y up, +X to the left. A material without a lobe is `diffuse`; others are `principled`
// (roughness is the root of α). A material without a diffuse part is a metal; one with a diffuse part and a coloured
// reflectance is a blend of a metal and a dielectric.
#include <gonio/asset/detail/mitsuba_text.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace gonio::asset_detail {

namespace {

std::string number(std::string_view name, double value) {
    return fmt::format(R"(<float name="{}" value="{}"/>)", name, value);
}

std::string count(std::string_view name, int value) {
    return fmt::format(R"(<integer name="{}" value="{}"/>)", name, value);
}

std::string word(std::string_view name, std::string_view value) {
    return fmt::format(R"(<string name="{}" value="{}"/>)", name, value);
}

std::string sensor(const SceneCamera& camera, int bounces) {
    const Frame& eye = camera.frame;
    const int max_depth = bounces + 2; // 1 shows emitters alone
    return fmt::format("    <integrator type=\"path\">{}</integrator>\n"
                       "    <sensor type=\"perspective\">\n"
                       "        {}\n"
                       "        {}{}{}{}\n"
                       "        <sampler type=\"independent\">{}</sampler>\n"
                       "        <film type=\"hdrfilm\">{}{}{}{}<rfilter type=\"box\"/></film>\n"
                       "    </sensor>\n",
                       count("max_depth", max_depth), mitsuba_matrix(-eye.x, eye.y, -eye.z, eye.origin),
                       word("fov_axis", "y"), number("fov", camera.vertical_fov * 180.0 / std::numbers::pi),
                       number("near_clip", 0.01), number("far_clip", 10000.0), count("sample_count", 1024),
                       count("width", camera.width), count("height", camera.height), word("pixel_format", "rgb"),
                       word("component_format", "float32"));
}

// `id` is empty, or the attribute by which shapes refer to the material.
std::string bsdf(std::string_view type, const std::string& id, const std::string& inside) {
    return fmt::format("    <bsdf type=\"{}\"{}>{}</bsdf>\n", type, id, inside);
}

std::string metal(const std::string& id, const glm::dvec3& f0, double alpha) {
    return bsdf("principled", id,
                mitsuba_rgb("base_color", f0) + number("metallic", 1.0) + number("roughness", std::sqrt(alpha)));
}

std::string dielectric(const std::string& id, const glm::dvec3& diffuse, double f0, double alpha) {
    if (f0 == 0.0) return bsdf("diffuse", id, mitsuba_rgb("reflectance", diffuse));
    // `specular` 1 is a reflectance of 0.08.
    return bsdf("principled", id,
                mitsuba_rgb("base_color", diffuse) + number("roughness", std::sqrt(alpha)) +
                    (f0 <= 0.08 ? number("specular", f0 / 0.08) : number("eta", refractive_index(f0))));
}

std::string material_text(const SceneMaterial& material) {
    const std::string id = fmt::format(" id=\"{}\"", material.name);
    const MixedMaterial parts = mixed(material);
    if (!material.has_lobe()) return dielectric(id, material.diffuse, 0.0, 1.0);
    if (parts.metal == 1.0) return metal(id, parts.metal_f0, material.alpha);
    if (parts.metal == 0.0) return dielectric(id, parts.diffuse, parts.f0, material.alpha);
    return bsdf("blendbsdf", id,
                number("weight", parts.metal) + "\n" + dielectric("", parts.diffuse, parts.f0, material.alpha) +
                    metal("", parts.metal_f0, material.alpha) + "    ");
}

std::string shape(std::string_view type, const std::string& inside, const std::string& material) {
    return fmt::format("    <shape type=\"{}\">\n        {}\n        {}\n    </shape>\n", type, inside, material);
}

std::string sphere(const glm::dvec3& center, double radius, const std::string& material) {
    return shape("sphere",
                 fmt::format(R"(<point name="center" value="{}"/>)", triple(center)) + number("radius", radius),
                 material);
}

struct ShapeText {
    std::string material;

    std::string operator()(const Panel& panel) const {
        const Frame& f = panel.frame;
        return shape("rectangle", mitsuba_matrix(0.5 * panel.width * f.x, 0.5 * panel.height * f.y, f.z, f.origin),
                     material);
    }
    std::string operator()(const Ball& ball) const { return sphere(ball.center, ball.radius, material); }
    std::string operator()(const Box& box) const {
        const Frame& f = box.frame;
        return shape("cube",
                     mitsuba_matrix(box.half_size.x * f.x, box.half_size.y * f.y, box.half_size.z * f.z, f.origin),
                     material);
    }
    std::string operator()(const Capsule& capsule) const {
        const glm::dvec3 half = capsule.half_length * capsule.axis;
        return sphere(capsule.center - half, capsule.radius, material) +
               sphere(capsule.center + half, capsule.radius, material) +
               shape("cylinder",
                     fmt::format(R"(<point name="p0" value="{}"/><point name="p1" value="{}"/>)",
                                 triple(capsule.center - half), triple(capsule.center + half)) +
                         number("radius", capsule.radius),
                     material);
    }
};

} // namespace

std::string mitsuba_stage(const SceneStage& stage) {
    std::string text = sensor(stage.camera, stage.bounces);
    for (const SceneMaterial& material : stage.materials)
        text += material_text(material);
    for (const SceneSurface& surface : stage.surfaces)
        text += fmt::format("    <!-- {} -->\n", surface.name) +
                std::visit(ShapeText{fmt::format(R"(<ref id="{}"/>)", stage.materials[surface.material].name)},
                           surface.shape);
    return text;
}

} // namespace gonio::asset_detail
