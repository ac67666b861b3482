// The methods of --method and --compare: for the light of shapes, and for what surrounds a surface.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/transport/surroundings_method.hpp>

#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace gonio::cli {

// One of the two is `exact`.
struct PictureMethod {
    IrradianceMethod light = IrradianceMethod::exact;
    SurroundingsMethod surroundings = SurroundingsMethod::exact;

    friend bool operator==(const PictureMethod&, const PictureMethod&) = default;
};

std::string_view to_text(const PictureMethod& method);

// Fails (usage) on an unknown name.
Result<PictureMethod> parse_picture_method(std::string_view name);

// "exact,split-sum": each once, in their order. Fails (usage) on an unknown name.
Result<std::vector<PictureMethod>> picture_methods(std::string_view list);

// Gives the options the local probe that one of the methods needs: at `probe_at`, else halfway between the camera and
// what it looks at. Nothing if none does. Fails (usage) as local_probe(); and if a method is about a sky and there is
// none.
Result<void> prepare(RenderOptions& options, std::span<const PictureMethod> methods, const Stage& stage,
                     std::span<const Light> lights, const std::optional<glm::dvec3>& probe_at);

} // namespace gonio::cli
