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

// The end of a ray that leaves the stage.
inline constexpr std::uint32_t no_patch = 0xffffffffU;
// The end of a ray that the back of a one-sided surface blocks.
inline constexpr std::uint32_t back_side = 0xfffffffdU;

// Unit directions about +Z as arrays of floats.
struct DirectionArrays {
    DirectionArrays() = default;
    explicit DirectionArrays(std::span<const glm::dvec3> directions);

    void add(const glm::dvec3& direction) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            axes.at(axis).push_back(static_cast<float>(direction[static_cast<int>(axis)]));
    }
    void clear();
    std::size_t size() const { return axes[0].size(); }
    glm::dvec3 of(std::size_t index) const;

    std::array<std::vector<float>, 3> axes;
};

// One for each thread.
class BundleCaster {
public:
    BundleCaster(const Stage& stage, const Patches& patches, simd::InstructionSet set);

    // All rays that follow start here. `own`: as RayCaster::cast().
    void begin(const Frame& from, std::size_t own);

    // Where each ray ends, or `no_patch` or `back_side`, and on which chart, or `no_patch`.
    void cast(const DirectionArrays& directions, std::span<PatchPoint> ends, std::span<std::uint32_t> charts);

    // Finds what rays towards points of a chart that are turned to where they start may meet, and whether that is
    // anything but the chart.
    bool find_nearer(std::uint32_t chart);
    // Of such rays, the chart that each meets first, or `no_patch`.
    void cast_toward(const DirectionArrays& directions, std::span<std::uint32_t> charts);

private:
    struct Target {
        std::uint32_t chart;
        bool blocks; // met from behind
        const PatchGrid* grid;
    };

    void add(const Panel& panel, std::size_t chart, bool is_solid);
    void add_rectangle(const Frame& frame, double half_width, double half_height, std::size_t chart);
    void run(const DirectionArrays& directions, const transport::RayTargets& targets);

    const Stage& stage_;
    const Patches& patches_;
    const transport::RayKernels& kernels_;
    Frame from_;
    std::vector<transport::RayRectangle> rectangles_;
    std::vector<transport::RaySphere> spheres_;
    std::vector<transport::RayCapsule> capsules_;
    std::vector<Target> of_rectangles_;
    std::vector<std::uint32_t> of_spheres_;  // their charts
    std::vector<std::uint32_t> of_capsules_; // the same
    // The directions from the rays' origin in which a target lies.
    struct Outline {
        glm::vec3 axis{0.0F};              // unit
        float cosine = -1.0F, sine = 0.0F; // of the angle about it; −1: in all directions
        float nearest_m = 0.0F;            // no point of it is nearer
    };
    static Outline outline_of(const glm::vec3& center, float radius);
    void find_outlines();
    std::vector<Outline> outlines_; // of rectangles, then spheres and capsules; made for the first that asks
    struct Nearer {                 // what may be met before a chart, and the chart itself
        std::vector<transport::RayRectangle> rectangles;
        std::vector<transport::RaySphere> spheres;
        std::vector<transport::RayCapsule> capsules;
        std::vector<std::uint32_t> charts; // in their order; no_patch: blocks
    };
    Nearer nearer_;
    std::vector<float> target_, distance_, u_, v_;
};

// A point of a chart, by its coordinates.
struct PatchPlace {
    std::uint32_t chart = no_patch; // or back_side
    float u = 0.0F;
    float v = 0.0F;
    float distance_m = 0.0F; // along the ray
};

// Rays with origins of their own. One for each thread.
class ScatteredCaster {
public:
    ScatteredCaster(const Stage& stage, const Patches& patches, simd::InstructionSet set);

    // The first `count` rays. Origins are relative to `anchor`, which is near them.
    void cast(const glm::dvec3& anchor, std::size_t own, const std::array<std::vector<float>, 3>& origins,
              const std::array<std::vector<float>, 3>& directions, std::size_t count, std::vector<PatchPlace>& ends);

private:
    void begin(const glm::dvec3& anchor, std::size_t own);

    const Stage& stage_;
    const Patches& patches_;
    const transport::RayKernels& kernels_;
    std::vector<transport::RayRectangle> rectangles_;
    std::vector<transport::RaySphere> spheres_;
    std::vector<transport::RayCapsule> capsules_;
    std::vector<std::uint32_t> charts_; // of rectangles, spheres and capsules
    std::vector<float> target_, distance_, u_, v_;
};

} // namespace gonio::detail
