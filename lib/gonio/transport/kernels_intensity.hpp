// How punctual lights distribute their intensity over directions, for many points at once, on the widest vector unit.
//
// Floats in structures of arrays, metres, one common frame. The lobes are those of shading/falloff.hpp; a web is looked
// up at its own angles, an image where the direction meets the plane one metre before the light. Each function
// multiplies the array, so fill it with the intensity along the axis first. Results are finite for finite input;
// nothing fails or allocates. The tests compare them with light.intensity_towards().
#pragma once

#include <gonio/simd/dispatch.hpp>

#include <cstddef>
#include <cstdint>

namespace gonio::transport {

struct Points {
    const float* position[3] = {}; // [m]
    std::size_t count = 0;
};

// Position and orientation of the light: γ = 0 of a web and the axis of a lobe are −z; C0 is x and C90 is y.
struct LightFrame {
    float origin[3] = {}; // [m]
    float x[3] = {1.0F, 0.0F, 0.0F};
    float y[3] = {0.0F, 1.0F, 0.0F};
    float z[3] = {0.0F, 0.0F, 1.0F};
};

struct LobeConstants {
    enum class Kind : std::uint8_t {
        none,
        frostbite,
        hard,
        linear_cos,
        smoothstep_cos,
        linear_angle,
        smoothstep_angle,
        frustum
    };

    Kind kind = Kind::none;
    float inner = 0.0F; // half angles of a spot [rad], inner ≤ outer; of a frustum those along x (inner) and y (outer)
    float outer = 0.0F;
};

// One axis of a table: ascending angles and, for uniform steps of the angle, the cell where the search begins.
struct TableAxis {
    const float* angles_deg = nullptr;         // `count`
    const float* inverse_width = nullptr;      // [1/deg] of each cell, `count` − 1
    const std::uint32_t* first_cell = nullptr; // for the step floor((angle − angles[0])·steps_per_deg)
    std::size_t count = 0;
    std::size_t steps = 0;
    float steps_per_deg = 0.0F;
    bool is_uniform = false; // all cells are as wide: the steps are the cells
};

struct WebConstants {
    // How a direction is converted to the angles of the table. Types A and B: `mirrors_x` and `mirrors_y` tell which
    // angles are stored on the positive side only. Type C: how C is brought into the range of the stored planes; axial
    // has only one plane.
    enum class Angles : std::uint8_t { axial, quadrant, bilateral_0_180, bilateral_90_270, full, type_a, type_b };

    Angles angles = Angles::axial;
    bool mirrors_x = false;
    bool mirrors_y = false;
    TableAxis horizontal;           // C, or H
    TableAxis vertical;             // γ, or V
    const float* candela = nullptr; // [horizontal][vertical]
    float scale = 1.0F;
};

// light/light_image.hpp: bilinear between the centres of its pixels.
struct ImageConstants {
    const float* pixels = nullptr; // [row][column]
    std::size_t width = 0;
    std::size_t height = 0;
    float slope_x = 1.0F; // of its right and its upper edge: half of what it covers at a distance of 1
    float slope_y = 1.0F;
};

// The faces of a luminous body.
struct BodyFaces {
    const float* normal[3] = {}; // of each flat face, times its area [m²]
    std::size_t count = 0;
    float round_m2 = 0.0F; // the projected area of all spheres
};

struct IntensityKernels {
    simd::InstructionSet set;
    void (*lobe)(const Points&, const LightFrame&, const LobeConstants&, float* cd);
    void (*web)(const Points&, const LightFrame&, const WebConstants&, float* cd);
    void (*image)(const Points&, const LightFrame&, const ImageConstants&, float* cd); // 0 outside of the image
    // Divides by the projected area towards directions of any length, times `side`; 0 where there is none.
    void (*per_projected_area)(const Points& directions, float side, const BodyFaces&, float* cd);
};

// The kernels of `set`, or the scalar ones where simd::available(set) is false.
const IntensityKernels& intensity_kernels(simd::InstructionSet set);

} // namespace gonio::transport
