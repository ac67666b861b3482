// Fixed bundles of rays from points of a stage: which patch each ray ends on. They depend on the stage alone, so they
// are traced once for all lights, colours and bounces.
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/transport/patches.hpp>
#include <gonio/transport/ray_caster.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gonio::detail {

// The end of a ray that leaves the stage, or that the back of a one-sided surface blocks.
inline constexpr std::uint32_t no_patch = 0xffffffffU;

// Directions about +Z with the density cosθ/π: a spiral of the golden angle over the unit disk (H. Vogel, 1979), so
// that the mean of a luminance over them, times π, is its illuminance.
std::vector<glm::dvec3> cosine_directions(std::size_t count);

// Two directions at right angles to a unit normal, which is Z.
Frame frame_about(const glm::dvec3& origin, const glm::dvec3& normal);

// Where the rays end, one for each direction in the frame. `own`: as RayCaster::cast().
void cast_bundle(const RayCaster& caster, const Patches& patches, const Frame& from, std::size_t own,
                 std::span<const glm::dvec3> directions, std::span<std::uint32_t> ends);

} // namespace gonio::detail
