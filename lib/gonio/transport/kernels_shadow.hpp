// How much of a light with a size many receivers see past what stands before it, on the widest vector unit.
//
// The light is divided into lines (scene/light_lines.hpp). Every body hides at most one piece of each line
// (scene/shadow_section.hpp, and scene/shadow_line.hpp if it is not apart from the light), and each line is divided
// into cells. All numbers are doubles, lengths metres; inside, what is relative to the light and the receiver is float.
// Every set gives the same bits, and a receiver's share does not depend on the others. Nothing fails or allocates.
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
    static constexpr double several = -1.0;                   // none, too
    static constexpr std::size_t numbers_of_body = 2 * lines; // that kernels keep of a body: what it hides of each line

    // One of each for each receiver.
    double* visible = nullptr; // share of the illuminance: exactly 1 if nothing is hidden, exactly 0 if all lines are
    double* hiding = nullptr;  // the number of the only body that hides a part of a line, or `several`

    // Optional, for receivers that see the light in part (of others they have no meaning): of each cell its visible
    // share, solid angle [sr] and the unit direction to its middle, at [cell · stride + receiver].
    std::size_t stride = 0;
    float* seen = nullptr;
    float* solid_angle = nullptr;
    float* towards[3] = {};
};

// Bytes of scratch memory for each body: for up to 16 lanes a mark and its numbers, in double, and the two ends of one
// piece of each line.
inline constexpr std::size_t shadow_scratch_bytes =
    16 * ((1 + ShadowShares::numbers_of_body) * sizeof(double) + 2 * ShadowShares::lines * sizeof(float));

// How many bodies may hide something of the light from a receiver: none, several, or the number of the only one.
struct NearBodies {
    static constexpr double none = -2.0;
    static constexpr double several = -1.0;
};

// Receivers before which a ball stands, each before its own.
struct ReceiversBehindBalls {
    ShadowReceivers receivers;
    const double* middle[3] = {}; // of the ball
    const double* radius = nullptr;
};

struct ShadowKernels {
    simd::InstructionSet set;
    // `scratch`: shadow_scratch_bytes for each body, aligned for doubles.
    void (*visible_shares)(const gonio::detail::LinedLight&, const gonio::detail::ShadowBody* bodies,
                           std::size_t body_count, const ShadowReceivers&, std::byte* scratch, const ShadowShares&);
    // `near`: for each receiver, of NearBodies. The other bodies hide nothing from it.
    void (*near_bodies)(const gonio::detail::LinedLight&, const gonio::detail::ShadowBody* bodies,
                        std::size_t body_count, const ShadowReceivers&, double* near);
    // The share of the illuminance of a uniform sphere light (`ball`) in closed form (scene/hidden_cap.hpp); −1 where
    // there is none.
    void (*share_past_balls)(const gonio::detail::LinedLight&, const ReceiversBehindBalls&, double* share);
};

// The kernels of `set`, or the scalar ones where simd::available(set) is false.
const ShadowKernels& shadow_kernels(simd::InstructionSet set);

} // namespace gonio::transport
