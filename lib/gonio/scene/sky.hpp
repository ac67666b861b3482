// An ambient sky: the same luminance from all directions, as on an overcast day or from the walls of a uniform room,
// and the share that the objects of a stage block.
//
// A receiver with a free view has E = π L in any orientation. An object in front of it removes the irradiance that it
// would give if it emitted L itself (shading/occlusion.hpp). Each primitive on its own is exact: sphere, capsule,
// rectangle, box (its faces towards the receiver) and plane. In combination: rectangles add up, because those of a room
// do not hide each other; that sum, planes and solids multiply, as if they overlapped at random.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/scene/core_material.hpp>
#include <gonio/scene/stage.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace gonio {

// "500lx", on an unobstructed plane, or "150nt". Fails (usage) on other units, and on less than 0.
Result<Nits> parse_sky(std::string_view text);

// The share of the sky's illuminance that reaches a point of surface `own`, in [0, 1]. `normal` is unit.
double sky_share(const Stage& stage, std::size_t own, const glm::dvec3& point, const glm::dvec3& normal);

// The luminance of a surface under a uniform sky of luminance 1: its directional albedo, by channel. A table over the
// cosine of the view, computed once per material; Lambert's is exact, others are within 0.5 % (a lattice of 1024
// directions each).
class SkyAlbedo {
public:
    enum class Fineness : std::uint8_t {
        coarse, // a twelfth of the time, within 1 %
        fine
    };
    SkyAlbedo() = default; // to be assigned
    explicit SkyAlbedo(const CoreMaterial& material, Fineness fineness = Fineness::fine);

    glm::dvec3 operator()(double cosine) const;

private:
    std::vector<glm::dvec3> albedo_; // at the cosines (i/(n−1))²; a single one for Lambert
};

} // namespace gonio
