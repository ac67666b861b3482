// The mean luminance of flat lights that are not uniform, as many receivers see it: by direction in columns, by place
// at nodes.
//
// Columns: in the light's frame (emission along −z, the receiver at p, depth −p_z > 0) the plane of the light is
// divided into columns: φ = atan((x − p_x)/depth), and along a column ψ = atan((y − p_y) cosφ/depth). Then dω = cosψ dψ
// dφ, and with T(φ, ψ) = L cosφ cosψ, the intensity of an element over its area,
//
//   E = ∫ dφ/cosφ [(n_x sinφ + n_z cosφ) ∫ T cosψ dψ + n_y ∫ T sinψ dψ].
//
// Both inner integrals are differences of a table of running integrals, cut in closed form where the column leaves the
// outline or passes below the receiver's horizon; the outer one is a Gauss–Legendre rule. What is returned is E over
// the same sum for L = 1, so that a Lambertian light has no error, and E itself is that ratio times its closed form.
//
// Floats in structures of arrays, metres, one common frame. Results are finite and ≥ 0; nothing fails or allocates.
#pragma once

#include <gonio/simd/dispatch.hpp>

#include <cstddef>

namespace gonio::transport {

struct Receivers {
    const float* position[3] = {}; // [m]
    const float* normal[3] = {};   // unit
    std::size_t count = 0;
};

// T over a uniform grid of φ (rows) and ψ (nodes), both from −90° to 90°, linear along a row between its nodes and
// between rows. For each node: ∫ T cosψ, T cosψ, ∫ T sinψ, T sinψ, the integrals from −90° on.
struct ColumnTable {
    const float* nodes = nullptr; // [row][node][4]
    std::size_t count = 0;        // of rows, and of the nodes of each
    float step_rad = 0.0F;
};

struct ColumnLight {
    float origin[3] = {};            // [m]
    float x[3] = {1.0F, 0.0F, 0.0F}; // across the columns
    float y[3] = {0.0F, 1.0F, 0.0F}; // along them
    float z[3] = {0.0F, 0.0F, 1.0F}; // against the emission
    float half_x = 0.0F;             // [m]
    float half_y = 0.0F;
    bool is_round = false;   // an ellipse with these half axes, or a rectangle
    float column_rad = 0.0F; // the angle for which one column is enough
    ColumnTable table;
};

// A rectangle of which points send light: nodes at (x, y, 0) of its frame, each with an area [m²] and that area times a
// luminance. An area dA sends dA ⟨n·l⟩ |z|/d³ to a receiver at the distance d and the height |z| over its plane.
struct NodeLight {
    float origin[3] = {};            // [m]
    float x[3] = {1.0F, 0.0F, 0.0F}; // of the rectangle
    float y[3] = {0.0F, 1.0F, 0.0F};
    float z[3] = {0.0F, 0.0F, 1.0F}; // against the emission
    bool two_sided = false;
};

struct LightNodes {
    const float* x = nullptr; // [m]
    const float* y = nullptr;
    const float* luminance = nullptr;
    const float* area = nullptr;
    std::size_t count = 0;
};

// What glossy lobes show of an area light, at points of a surface.
struct LobePoints {
    const float* position[3] = {}; // [m]
    const float* normal[3] = {};   // unit
    const float* view[3] = {};     // unit, towards the eye
    std::size_t count = 0;
};

struct LobeLight {
    float origin[3] = {};            // the middle [m]
    float x[3] = {1.0F, 0.0F, 0.0F}; // of a flat light
    float y[3] = {0.0F, 1.0F, 0.0F};
    float z[3] = {0.0F, 0.0F, 1.0F};
    bool is_flat = false;
    bool is_round = false;
    float half_x = 0.0F; // [m]
    float half_y = 0.0F;
    float radius = 0.0F;
    float lobe_rad = 0.0F; // half of the angle that the lobe covers, about
};

// One of each for each point.
struct LobeViews {
    // a²/(a² + b²) for the angle a that the radius of the light subtends and that of the lobe, b: 1 for a narrow lobe.
    float* narrow = nullptr;
    // From where the mirrored view meets the light, or its edge, to the point [m]; from the middle of one that is not
    // flat.
    float* towards[3] = {};
};

struct LuminanceKernels {
    simd::InstructionSet set;
    // Adds to `share`; 0 behind the light and where it is below the horizon.
    void (*columns)(const Receivers&, const ColumnLight&, float* share);
    // Sets `share` to the mean luminance of the nodes, ≥ 0; 0 where none of them is above the horizon or emits there.
    void (*nodes)(const Receivers&, const NodeLight&, const LightNodes&, float* share);
    void (*lobes)(const LobePoints&, const LobeLight&, const LobeViews&);
};

// The kernels of `set`, or the scalar ones where simd::available(set) is false.
const LuminanceKernels& luminance_kernels(simd::InstructionSet set);

} // namespace gonio::transport
