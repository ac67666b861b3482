// Where a light gives nothing at all, by bounds: what a renderer can skip without changing its picture.
//
// Every test is conservative: it reports that a light gives nothing only where each point gets exactly 0.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/transport/sample_bounds.hpp>
#include <gonio/web/web.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>

namespace gonio::detail {

// Directions within an angle of an axis.
struct DirectionCone {
    glm::dvec3 axis{0.0, 0.0, -1.0}; // unit
    double sine = 0.0;               // of the half angle, in [0, π]
    double cosine = -1.0;
};

enum class Unlit : std::uint8_t { no, out_of_range, outside_cone, below_horizon };

struct LightReach {
    glm::dvec3 center{0.0};
    double body_radius = 0.0;           // of the bounding sphere of the luminous surface about the centre
    double range = 0.0;                 // beyond it the window is 0; infinite without a window
    bool at_infinity = false;           // the sun: `toward` is used instead of the centre
    glm::dvec3 toward{0.0, 0.0, 1.0};   // unit, to the sun
    double angular_radius_sin = 0.0;    // of the sun
    std::array<DirectionCone, 3> cones; // from the centre; all light leaves inside every one of them
    std::size_t cone_count = 0;

    // Why no point within the bounds gets light; `no` if one may.
    Unlit unlit(const SampleBounds& bounds) const;
};

// The least and the greatest cosine of γ in which a web has light: found once for all lights with this web.
struct LitCosines {
    double least = 1.0;
    double greatest = -1.0;
};
using WebsLitCosines = std::map<const Web*, LitCosines>;

// `mask_from_center`: the mask of a light with a size is evaluated from its centre to the point. `known` gets what was
// not in it.
LightReach reach_of(const Light& light, bool mask_from_center, WebsLitCosines& known);
LightReach reach_of(const Light& light, bool mask_from_center);

// Whether the light emits at all.
bool is_dark(const Light& light);

} // namespace gonio::detail
