// An ambient sky: the same luminance from all directions, as an overcast day or the walls of an even room give, and
// what the bodies of a stage take of it away.
//
// A receiver that sees nothing else has E = π L, however it is turned. A body in front takes away what it would give if
// it shone with L itself (shading/occlusion.hpp). By itself each primitive is exact: ball, capsule, panel, box (its
// faces that look at the receiver) and plane. Together: panels add up, for those of a room do not hide each other; that
// sum, planes and solids multiply, as if they stood before each other by chance.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/scene/core_material.hpp>
#include <gonio/scene/stage.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <string_view>
#include <vector>

namespace gonio {

// "500lx", on an unobstructed plane, or "150nt". Fails (usage) on other units, and on less than 0.
Result<Nits> parse_sky(std::string_view text);

// The share of the sky's illuminance that reaches a point of surface `own`, in [0, 1]. `normal` is unit.
double sky_share(const Stage& stage, std::size_t own, const glm::dvec3& point, const glm::dvec3& normal);

// What a surface shows under an even sky of luminance 1: its directional albedo, by channels. A table over the cosine
// of the view, made once for a material; Lambert's is exact, others within 0.5 % (a lattice of 1024 directions each).
class SkyAlbedo {
public:
    explicit SkyAlbedo(const CoreMaterial& material);

    glm::dvec3 operator()(double cosine) const;

private:
    std::vector<glm::dvec3> albedo_; // at the cosines (i/(n−1))²; one of Lambert's
};

} // namespace gonio
