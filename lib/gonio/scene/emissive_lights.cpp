#include <gonio/base/kind_text.hpp>
#include <gonio/scene/emissive_lights.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace gonio {

namespace {

// The place and direction of the area light of a surface that is one.
struct Placed {
    LightDescription& light;

    void operator()(const Panel& panel) const {
        light.position = panel.frame.origin;
        light.direction = panel.frame.z;
        light.up = panel.frame.y;
    }
    void operator()(const Ball& ball) const { light.position = ball.center; }
    void operator()(const Capsule& capsule) const {
        // The tube runs along X = Y × Z, with Z = −direction and Y = up.
        light.position = capsule.center;
        light.direction = -aimed_frame(capsule.center, capsule.axis, {0.0, 0.0, 1.0}).y;
        light.up = glm::cross(capsule.axis, light.direction);
    }
    template<class Other>
    void operator()(const Other& /*not a light*/) const {}
};

// In the box's own frame, Z up and Y away.
constexpr std::array<std::string_view, 6> face_names{"right", "left", "back", "front", "top", "bottom"};

// The six rectangles of a box, of one luminance.
void add_faces(const Box& box, const LightDescription& of_box, std::size_t surface,
               std::vector<LightDescription>& lights) {
    for (int i = 0; i < 6; ++i) {
        const Panel side = face(box, i);
        LightDescription& light = lights.emplace_back(of_box);
        light.name += fmt::format("-{}", face_names.at(static_cast<std::size_t>(i)));
        light.shape = RectShape{Meters(side.width), Meters(side.height)};
        light.emitted_by = EmittingFace{surface, i};
        Placed{light}(side);
    }
}

std::string name_of(const Stage& stage, std::size_t surface) {
    const std::string& name = stage.surfaces[surface].name;
    std::size_t before = 0;
    std::size_t all = 0;
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i) {
        if (stage.surfaces[i].name != name || !stage.surfaces[i].emits) continue;
        ++all;
        if (i < surface) ++before;
    }
    return all > 1 ? fmt::format("{}-{}", name, before + 1) : name;
}

} // namespace

Result<void> let_emit(Stage& stage, const NamedEmission& named) {
    bool found = false;
    for (Surface& surface : stage.surfaces) {
        if (surface.name != named.surface) continue;
        Result<Nits> luminance = emitted_luminance(surface.geometry, named.emission.amount);
        if (!luminance) return pass_on(luminance);
        surface.emits = named.emission;
        found = true;
    }
    if (!found) return unknown_name("surface", named.surface, surface_names(stage), stage.name);
    return {};
}

Result<std::vector<LightDescription>> emissive_lights(const Stage& stage) {
    std::vector<LightDescription> lights;
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i) {
        const Surface& surface = stage.surfaces[i];
        if (!surface.emits) continue;
        Result<Nits> luminance = emitted_luminance(surface.geometry, surface.emits->amount);
        if (!luminance) return pass_on(luminance);
        LightDescription light;
        light.name = name_of(stage, i);
        light.color = surface.emits->color;
        light.emitted_by = EmittingFace{i, 0};
        if (const auto* const box = std::get_if<Box>(&surface.geometry)) {
            light.intensity = PhotometricValue{luminance->value, {find_unit("nt"), std::nullopt, std::nullopt}};
            add_faces(*box, light, i, lights);
            continue;
        }
        light.shape = *light_shape(surface.geometry);
        light.intensity = surface.emits->amount;
        std::visit(Placed{light}, surface.geometry);
        lights.push_back(std::move(light));
    }
    return lights;
}

EmittedLights::EmittedLights(const Stage& stage, std::span<const Light> lights) {
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const std::optional<EmittingFace>& from = lights[i].emitted_by;
        if (!from || from->surface >= stage.surfaces.size() || from->face < 0 || from->face >= 6) continue;
        if (by_face_.empty()) {
            by_face_.resize(stage.surfaces.size());
            for (std::array<std::uint32_t, 6>& faces : by_face_)
                faces.fill(none);
        }
        by_face_[from->surface].at(static_cast<std::size_t>(from->face)) = static_cast<std::uint32_t>(i);
    }
}

std::optional<std::uint32_t> EmittedLights::at(const Hit& hit) const {
    if (by_face_.empty()) return std::nullopt;
    const std::uint32_t light = by_face_[hit.surface].at(static_cast<std::size_t>(hit.face));
    return light == none ? std::nullopt : std::optional(light);
}

bool EmittedLights::emits(std::size_t surface) const {
    return !by_face_.empty() && std::any_of(by_face_[surface].begin(), by_face_[surface].end(),
                                            [](std::uint32_t light) { return light != none; });
}

} // namespace gonio
