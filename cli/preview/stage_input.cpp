#include "stage_input.hpp"

#include <gonio/base/kind_text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/scene/figure.hpp>
#include <gonio/scene/material_charts.hpp>

#include "../options/values.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace gonio::cli {

namespace {

// "wall=lambert:albedo=0.7" or "lambert:albedo=0.7".
Result<void> apply_material(std::string_view text, Stage& stage, Diagnostics& diagnostics) {
    const std::size_t equals = text.find('=');
    const bool is_named = names_surface(text);
    Result<Material> material = parse_material(is_named ? text.substr(equals + 1) : text);
    if (!material) return pass_on(material);
    const Diagnostics judged = check_charts(*material);
    diagnostics.insert(diagnostics.end(), judged.begin(), judged.end());
    if (is_named) return give_material(stage, {std::string(text.substr(0, equals)), *material});
    for (Surface& surface : stage.surfaces)
        if (surface.subject) surface.material = *material;
    return {};
}

Result<void> apply_camera(const Arguments& arguments, Camera& camera) {
    const auto read = [&](const char* option, glm::dvec3& target) -> Result<void> {
        const auto text = arguments.value(option);
        if (!text) return {};
        Result<glm::dvec3> vector = parse_vector(*text, option);
        if (!vector) return pass_on(vector);
        target = *vector;
        return {};
    };
    Result<void> applied = read("--camera", camera.position);
    if (applied) applied = read("--target", camera.target);
    if (!applied) return applied;
    if (const auto text = arguments.value("--fov")) return read_field_of_view(*text, camera);
    return {};
}

} // namespace

bool names_surface(std::string_view material) {
    const std::size_t equals = material.find('=');
    return equals != std::string_view::npos && equals < material.find(':');
}

Result<void> give_material(Stage& stage, const SurfaceMaterial& named) {
    bool found = false;
    for (Surface& surface : stage.surfaces) {
        if (surface.name != named.surface) continue;
        surface.material = named.material;
        found = true;
    }
    if (!found) return unknown_name("surface", named.surface, surface_names(stage), stage.name);
    return {};
}

Result<void> read_field_of_view(const std::string& text, Camera& camera) {
    Result<double> angle = parse_amount(text, Dimension::angle, "--fov");
    if (!angle) return pass_on(angle);
    camera.vertical_fov_deg = to_degrees(Radians(*angle));
    camera.least_horizontal_fov_deg = 0.0;
    if (!(camera.vertical_fov_deg > 0.0 && camera.vertical_fov_deg < 180.0))
        return fail("USE0106", fmt::format("--fov must lie between 0deg and 180deg, not {}", text));
    return {};
}

Result<Stage> named_stage(const Arguments& arguments) {
    return make_stage(arguments.value("--stage").value_or(std::string(stage_kinds().front().name)));
}

Result<void> give_materials(const Arguments& arguments, const Rig& rig, Stage& stage, Diagnostics& diagnostics) {
    Result<void> given;
    for (const SurfaceMaterial& material : rig.materials)
        if (given) given = give_material(stage, material);
    for (const std::string& text : arguments.values("--material"))
        if (given) given = apply_material(text, stage, diagnostics);
    return given;
}

Result<Stage> stage_input(const Arguments& arguments, const Rig& rig, const Stage& named, Diagnostics& diagnostics) {
    Stage stage = rig.stage && !arguments.has("--stage") ? *rig.stage : named;
    if (rig.camera) stage.camera = *rig.camera;
    Result<void> applied = give_materials(arguments, rig, stage, diagnostics);
    if (arguments.has("--figure")) add_figure(stage);
    if (applied) applied = apply_camera(arguments, stage.camera);
    if (applied) applied = check_camera(stage, stage.camera);
    if (!applied) return pass_on(applied);
    return stage;
}

} // namespace gonio::cli
