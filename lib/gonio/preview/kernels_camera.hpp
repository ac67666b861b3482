// Camera rays on the widest vector unit: their directions, and where they meet a primitive.
//
// All numbers are doubles, lengths metres. Every set gives the same bits, those of CameraRays::ray() and first_hit().
// Nothing fails or allocates.
#pragma once

#include <gonio/simd/dispatch.hpp>

#include <cstddef>
#include <cstdint>

namespace gonio::preview {

// Rays from one point: unit directions by axis.
struct CameraRayArrays {
    double origin[3] = {};
    const double* direction[3] = {};
    std::size_t count = 0;
};

// A row of a picture: the ray i goes through start + (first + i)·step + down, from the eye.
struct CameraRow {
    double start[3] = {};
    double step[3] = {};
    double down[3] = {};
    double first = 0.0;
};

// A primitive, as its place relative to the rays' origin.
struct CameraTarget {
    enum class Kind : std::uint8_t { plane, panel, ball, box, capsule };

    Kind kind = Kind::plane;
    // Of a ball and a capsule. Of a panel in the coordinates of the stage. Of a box the rays' origin, from its middle
    // and in its axes.
    double middle[3] = {};
    double x[3] = {}; // unit: y and normal with it of a panel and a box, the axis of a capsule
    double y[3] = {};
    double normal[3] = {};    // planes and panels are met from its side
    double height = 0.0;      // of their points along the normal; of a capsule's middle along its axis
    double half_size[3] = {}; // of a panel and a box; of a capsule, the first to the middles of its ends
    double radius = 0.0;
    double ends[2][3] = {}; // the middles of a capsule's ends, the second along its axis
};

struct CameraKernels {
    simd::InstructionSet set;
    void (*directions)(const CameraRow&, std::size_t count, double* const (&direction)[3]);
    // Puts the distance and the `number` of the target where rays meet it before what they met until now.
    void (*meet)(const CameraTarget&, const CameraRayArrays&, double number, double* distance, double* numbers);
    // The points at these distances less the anchor, by axis.
    void (*positions)(const CameraRayArrays&, const double* distance, const double (&anchor)[3],
                      float* const (&position)[3]);
    // Towards the eye, by axis.
    void (*views)(const CameraRayArrays&, float* const (&view)[3]);
};

// The kernels of `set`, or the scalar ones where simd::available(set) is false.
const CameraKernels& camera_kernels(simd::InstructionSet set);

} // namespace gonio::preview
