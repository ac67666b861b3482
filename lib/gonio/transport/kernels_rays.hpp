// The first target that each ray meets, and what a place sees of cells, many at once, on the widest vector unit.
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

struct RayCapsule {
    float center[3] = {};
    float axis[3] = {}; // unit
    float half_length = 0.0F;
    float radius = 0.0F;
};

struct RayTargets {
    const RayRectangle* rectangles = nullptr;
    std::size_t rectangle_count = 0;
    const RaySphere* spheres = nullptr; // the point is outside
    std::size_t sphere_count = 0;
    const RayCapsule* capsules = nullptr; // as spheres
    std::size_t capsule_count = 0;
};

struct RayFrame {
    float x[3] = {1.0F, 0.0F, 0.0F};
    float y[3] = {0.0F, 1.0F, 0.0F};
    float z[3] = {0.0F, 0.0F, 1.0F};
};

// One of each for each ray.
struct RayHits {
    static constexpr float nothing = -1.0F;
    static constexpr float back = -2.0F; // the back of a rectangle; only of scattered rays

    float* target = nullptr;   // the number of a rectangle, then of a sphere, then of a capsule
    float* distance = nullptr; // [m]
    // On a rectangle, along x and y from its middle [m]; on a sphere, the azimuth about the world's Z from X, in
    // [−π, π], and the elevation [rad]; on a capsule, any numbers.
    float* u = nullptr;
    float* v = nullptr;
};

// Parts of surfaces, as linked_cells.hpp has them.
struct RayCells {
    const float* position[3] = {}; // relative to a point near them [m]
    const float* normal[3] = {};   // unit
    const float* spread = nullptr; // the sine of the greatest angle between the normals of a cell and its own
    const float* reach = nullptr;  // of flat ones, to their corners [m]; else 0
    const float* area_m2 = nullptr;
    const float* least2 = nullptr; // the squared distance from which they are linked as a whole [m²]
    std::size_t count = 0;
};

// How a place is linked to each cell.
struct RayLinks {
    // Of a cell that is linked as a whole its form factor and a little more; 0: the cell and the place do not see each
    // other; `divided`: it is too near, or not alike enough, to be looked at as one.
    static constexpr float divided = -1.0F;
    static constexpr float least = 1e-37F;
    float* share = nullptr;
    float* towards[3] = {}; // unit, in the frame
};

struct RayKernels {
    simd::InstructionSet set;
    // All rays start at the point. `directions`: unit, in the frame.
    void (*first_hits)(const RayTargets&, const RayFrame&, const float* const directions[3], std::size_t count,
                       const RayHits&);
    // Each ray has its own origin.
    void (*first_hits_of_scattered)(const RayTargets&, const float* const origins[3], const float* const directions[3],
                                    std::size_t count, const RayHits&);
    // Of a place, relative to the same point, whose normal is Z of the frame.
    void (*cell_links)(const RayCells&, const float (&place)[3], const RayFrame&, const RayLinks&);
};

// The kernels of `set`, or the scalar ones where simd::available(set) is false.
const RayKernels& ray_kernels(simd::InstructionSet set);

} // namespace gonio::transport
