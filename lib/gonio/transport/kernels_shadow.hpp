// How much of a light with a size many receivers see past what stands before it, on the widest vector unit.
//
// The light is divided into lines (scene/light_lines.hpp). Every body hides at most one piece of each line
// (scene/shadow_line.hpp), and each line is divided into cells. All numbers are doubles, lengths metres. Every set
// gives the same bits, and a receiver's share does not depend on the others. Nothing fails or allocates.
#pragma once

#include <gonio/scene/shadow_numbers.hpp>
#include <gonio/simd/dispatch.hpp>

#include <cstddef>

namespace gonio::transport {

struct ShadowReceivers {
    const double* position[3] = {}; // in the coordinates of the stage
    const double* normal[3] = {};   // unit
    std::size_t count = 0;
};

struct ShadowShares {
    static constexpr std::size_t lines = 8;
    static constexpr std::size_t cells_of_line = 4;
    static constexpr std::size_t cells = lines * cells_of_line;
    static constexpr double several = -1.0; // none, too

    // One of each for each receiver.
    double* visible = nullptr; // share of the illuminance: exactly 1 if nothing is hidden, exactly 0 if all lines are
    double* hiding = nullptr;  // the number of the only body that hides a part of a line, or `several`

    // Optional, for receivers that see the light in part (of others they have no meaning): of each cell its visible
    // share, solid angle [sr] and the unit direction to its middle, at [cell · stride + receiver].
    std::size_t stride = 0;
    double* seen = nullptr;
    double* solid_angle = nullptr;
    double* towards[3] = {};
};

// Doubles of scratch memory for each body: for up to 8 lanes a mark, and the two ends of one piece of each line.
inline constexpr std::size_t shadow_scratch_numbers = 8 * (1 + 2 * ShadowShares::lines);

struct ShadowKernels {
    simd::InstructionSet set;
    // `scratch`: shadow_scratch_numbers doubles for each body.
    void (*visible_shares)(const gonio::detail::LinedLight&, const gonio::detail::ShadowBody* bodies,
                           std::size_t body_count, const ShadowReceivers&, double* scratch, const ShadowShares&);
};

// The kernels of `set`, or the scalar ones where simd::available(set) is false.
const ShadowKernels& shadow_kernels(simd::InstructionSet set);

} // namespace gonio::transport
