#include "rig_surfaces.hpp"

#include <gonio/base/unit_text.hpp>
#include <gonio/scene/primitives.hpp>

#include <fmt/format.h>

#include <variant>

namespace gonio::cli {

namespace {

// Without signs of zeros.
Json vector_json(const glm::dvec3& value) {
    return Json::array({value.x + 0.0, value.y + 0.0, value.z + 0.0});
}

} // namespace

Json panels_json(const Stage& stage) {
    Json surfaces = Json::array();
    for (const Surface& surface : stage.surfaces) {
        const auto& panel = std::get<Panel>(surface.geometry);
        const auto& matte = std::get<LambertMaterial>(surface.material);
        const Json shape{{"center", vector_json(panel.frame.origin)},
                         {"normal", vector_json(panel.frame.z)},
                         {"up", vector_json(panel.frame.y)},
                         {"width", shortest(panel.width) + "m"},
                         {"height", shortest(panel.height) + "m"}};
        surfaces.push_back(Json{{"name", surface.name},
                                {"panel", shape},
                                {"material", fmt::format("lambert:albedo={}", shortest(matte.albedo.x))}});
    }
    return surfaces;
}

} // namespace gonio::cli
