// What a place sees of parts of flat patches, many at once: form factors that are sums over edges (J. H. Lambert,
// "Photometria", 1760), on the widest vector unit.
//
// All numbers are doubles, lengths metres; every set gives the same bits. Nothing fails or allocates. The tests compare
// them with seen_above() of form_factor.hpp.
#pragma once

#include <gonio/simd/dispatch.hpp>

#include <cstddef>

namespace gonio::transport {

// Rectangles on one plane, in the frame of a place: the place is the origin, and its normal is Z. They are small beside
// their distance, four of their half diagonals at least, and above the horizon.
struct FlatParts {
    double x[3] = {1.0, 0.0, 0.0}; // unit, along their sides
    double y[3] = {0.0, 1.0, 0.0};
    // One of each for each part.
    const double* middle[3] = {};
    const double* half_side[2] = {}; // along x and y
    const double* factor = nullptr;  // of the form factor
    // Of the patch that it is a part of, in sides of that: its middle from the patch's, and half of its sides.
    const double* at[2] = {};
    const double* half[2] = {};
    std::size_t count = 0;
};

// One of each for each part.
struct PartShares {
    double* share = nullptr; // the form factor times the factor
    double* moment[2] = {};  // of the share about the middle of the patch, in its sides: the nearer side counts more
};

struct PartKernels {
    simd::InstructionSet set;
    void (*shares)(const FlatParts&, const PartShares&);
};

// The kernels of `set`, or the scalar ones where simd::available(set) is false.
const PartKernels& part_kernels(simd::InstructionSet set);

} // namespace gonio::transport
