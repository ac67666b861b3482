// The rays of a bundle against all surfaces of a stage, many at once.
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/simd/dispatch.hpp>
#include <gonio/transport/kernels_rays.hpp>
#include <gonio/transport/patches.hpp>
#include <gonio/transport/ray_caster.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gonio::detail {

// The end of a ray that leaves the stage, or that the back of a one-sided surface blocks.
inline constexpr std::uint32_t no_patch = 0xffffffffU;

// Directions about +Z as arrays of floats.
struct DirectionArrays {
    explicit DirectionArrays(std::span<const glm::dvec3> directions);

    std::vector<glm::dvec3> exact;
    std::array<std::vector<float>, 3> rounded;
};

// One for each thread.
class BundleCaster {
public:
    BundleCaster(const Stage& stage, const RayCaster& caster, const Patches& patches, simd::InstructionSet set);

    // The patch that each ray ends on. `own`: as RayCaster::cast().
    void cast(const Frame& from, std::size_t own, const DirectionArrays& directions, std::span<std::uint32_t> ends);

private:
    struct Target {
        std::size_t chart;
        bool blocks; // met from behind
    };

    void add(const Panel& panel, std::size_t chart, bool is_solid, const Frame& from);
    void add(const Plane& plane, std::size_t chart, const Frame& from);
    void add_rectangle(const Frame& frame, double half_width, double half_height, std::size_t chart, const Frame& from);

    const Stage& stage_;
    const RayCaster& caster_;
    const Patches& patches_;
    const transport::RayKernels& kernels_;
    std::vector<transport::RayRectangle> rectangles_;
    std::vector<transport::RaySphere> spheres_;
    std::vector<transport::RaySphere> bounds_;
    std::vector<Target> of_rectangles_;
    std::vector<std::size_t> of_spheres_; // their charts
    std::vector<float> target_, distance_, u_, v_;
};

} // namespace gonio::detail
