// The methods of --method and --compare: for the light of shapes, and for what surrounds a surface.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/transport/surroundings_method.hpp>

#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::cli {

// One of the two is `exact`, or both have the same name: Frostbite's dominant direction is one for highlights of lights
// and one for skies.
struct PictureMethod {
    IrradianceMethod light = IrradianceMethod::exact;
    SurroundingsMethod surroundings = SurroundingsMethod::exact;

    friend bool operator==(const PictureMethod&, const PictureMethod&) = default;
};

std::string_view to_text(const PictureMethod& method);

// The method of these options, and the options with that method.
PictureMethod method_of(const RenderOptions& options);
void set_method(RenderOptions& options, const PictureMethod& method);

struct PictureMethodInfo {
    std::string_view name;
    std::string summary;
    PictureMethod method;
};

// Those for lights, then those for surroundings; each name once.
std::vector<PictureMethodInfo> picture_methods();

// Fails (usage) on an unknown name.
Result<PictureMethod> parse_picture_method(std::string_view name);

// "exact,split-sum": each once, in their order. Fails (usage) on an unknown name.
Result<std::vector<PictureMethod>> parse_picture_methods(std::string_view list);

// Fails (usage) if a method is about the light of a sky alone and there is none.
Result<void> check_sky(std::span<const PictureMethod> methods, const Sky& sky);

// Gives the options the local probe that one of the methods needs: at `probe_at`, else halfway between the camera and
// what it looks at. Nothing if none does. Fails (usage) as local_probe().
Result<void> prepare(RenderOptions& options, std::span<const PictureMethod> methods, const Stage& stage,
                     std::span<const Light> lights, const std::optional<glm::dvec3>& probe_at);

} // namespace gonio::cli
