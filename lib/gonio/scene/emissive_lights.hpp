// The lights of a stage: what its surfaces emit, as area lights of their shapes.
//
// Everything that has lights takes these beside the others: probes, pictures, bounced light and exports. They differ
// from other lights in one thing: Light::emitted_by names their surface, which does not block them, receives nothing of
// them and shows their luminance in addition to what it reflects.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/stage.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// The emission of the surfaces of that name on the stage.
struct NamedEmission {
    std::string surface;
    SurfaceEmission emission;
};

// Lets every surface of that name emit this amount, each for itself, in place of what it emitted before. Fails (usage)
// if the stage has none, and as emitted_luminance() does.
Result<void> let_emit(Stage& stage, const NamedEmission& named);

// In the order of the surfaces; a box is six rectangles, in the order of face(). A light has the name of its surface;
// where several share it, they are numbered: "lamp-1". Faces of a box are called after the box's own axes, Z up and Y
// away: "crate-right", "-left", "-back", "-front", "-top", "-bottom". Fails as emitted_luminance() does.
Result<std::vector<LightDescription>> emissive_lights(const Stage& stage);

// Which of the lights a point of a surface shows as its own.
class EmittedLights {
public:
    EmittedLights() = default;
    EmittedLights(const Stage& stage, std::span<const Light> lights);

    bool empty() const { return by_face_.empty(); }
    // Its index among the lights.
    std::optional<std::uint32_t> at(const Hit& hit) const;
    bool emits(std::size_t surface) const;

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    std::vector<std::array<std::uint32_t, 6>> by_face_; // by surface; empty if no surface emits
};

} // namespace gonio
#pragma GCC visibility pop
