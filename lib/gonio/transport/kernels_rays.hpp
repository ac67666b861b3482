// The first target that each ray meets, for many rays at once, on the widest vector unit.
//
// Floats, metres; all positions are relative to one point near the rays' origins, so that they keep their digits.
// Nothing fails or allocates. The tests compare them with RayCaster.
#pragma once

#include <gonio/simd/dispatch.hpp>

#include <cstddef>

namespace gonio::transport {

// A rectangle or, with infinite sides, a plane, met from both sides.
struct RayRectangle {
    float normal[3] = {};
    float height = 0.0F; // of the plane along the normal, from the point
    float x[3] = {};     // unit, along the sides
    float y[3] = {};
    float middle[2] = {}; // along x and y
    float half_size[2] = {};
    bool is_solid = false; // a side of a solid, which rays from behind pass
};

struct RaySphere {
    float center[3] = {};
    float radius = 0.0F;
};

// What a capsule lies in: a sphere, and an endless cylinder.
struct RayBounds {
    RaySphere sphere;
    float axis[3] = {}; // unit, through the sphere's centre
    float radius = 0.0F;
};

struct RayTargets {
    const RayRectangle* rectangles = nullptr;
    std::size_t rectangle_count = 0;
    const RaySphere* spheres = nullptr; // the point is outside
    std::size_t sphere_count = 0;
    // Around targets that are tested elsewhere: rays that may meet one of them first are only marked.
    const RayBounds* bounds = nullptr;
    std::size_t bound_count = 0;
};

struct RayFrame {
    float x[3] = {1.0F, 0.0F, 0.0F};
    float y[3] = {0.0F, 1.0F, 0.0F};
    float z[3] = {0.0F, 0.0F, 1.0F};
};

// One of each for each ray.
struct RayHits {
    static constexpr float nothing = -1.0F;
    static constexpr float unknown = -2.0F; // one of the bounds may be met first
    static constexpr float back = -3.0F;    // the back of a rectangle; only of scattered rays

    float* target = nullptr;   // the number of a rectangle, or from rectangle_count on of a sphere
    float* distance = nullptr; // [m]
    // On a rectangle, along x and y from its middle [m]; on a sphere, the azimuth about the world's Z from X, in
    // [−π, π], and the elevation [rad].
    float* u = nullptr;
    float* v = nullptr;
};

struct RayKernels {
    simd::InstructionSet set;
    // All rays start at the point. `directions`: unit, in the frame.
    void (*first_hits)(const RayTargets&, const RayFrame&, const float* const directions[3], std::size_t count,
                       const RayHits&);
    // Each ray has its own origin.
    void (*first_hits_of_scattered)(const RayTargets&, const float* const origins[3], const float* const directions[3],
                                    std::size_t count, const RayHits&);
};

// The kernels of `set`, or the scalar ones where simd::available(set) is false.
const RayKernels& ray_kernels(simd::InstructionSet set);

} // namespace gonio::transport
