// Shading of many surface points by one light, with the widest instruction set that the machine has.
//
// All arrays are float, in structures of arrays; positions in metres, directions of unit length, all in one frame.
// Units: candela, luminance in cd/m² (nt), illuminance in lx. Results are finite and not negative for any finite input:
// light on the point, point inside the sphere, n·v ≤ 0, coordinates up to the largest float. The functions do not fail,
// allocate or throw; calls are independent of each other and may run on any thread. Cost: see README.md.
//
// The formulas are in shade.hpp, once for float, double and packs; the double versions are the reference for the tests.
#pragma once

#include <gonio/shading/coat_order.hpp>
#include <gonio/shading/specular_method.hpp>
#include <gonio/simd/dispatch.hpp>

#include <cstddef>
#include <cstdint>

namespace gonio::shading {

// `count` can be any number; arrays need no alignment.
struct Surfaces {
    const float* position[3] = {}; // [m]
    const float* normal[3] = {};   // unit
    const float* view[3] = {};     // unit, from the surface towards the eye; not read for lambert, may be null there
    std::size_t count = 0;
};

struct LightConstants {
    enum class Kind : std::uint8_t { punctual, sphere, disk, ellipse, rectangle, tube, cylinder, sun };

    Kind kind = Kind::punctual;
    float position[3] = {}; // [m], of the centre; not read for a sun
    float radius = 0.0F;    // sphere, disk, tube, cylinder [m], ≥ 0
    // Area lights: luminance of the three channels [nt]; punctual: weights of a colour with luminance Y = 1. All ≥ 0.
    float color[3] = {1.0F, 1.0F, 1.0F};
    const float* intensity_cd = nullptr; // punctual: towards each surface point, ≥ 0, `count` of them; else not read
    float inverse_range = 0.0F;          // [1/m] of the squared window (falloff.hpp); 0 = no window; not read for a sun
    // The method `shade` uses for the glossy part of an area light; ignored for a punctual light.
    SpecularMethod specular_method = standard_specular_method;
    // Factors on the colour of an area light for each surface point, ≥ 0, `count` of them, or null: on what all of the
    // surface but its lobes reflects, and on what these do. Read by `shade` alone.
    const float* share = nullptr;
    const float* lobe_share = nullptr;
    float angular_radius = 0.0F; // sun [rad], half of its diameter; in [0, π/2]
    // The rest is read by flat lights (disk, ellipse, rectangle), tube, cylinder and (only the axis) the sun.
    float axis[3] = {0.0F, 0.0F, -1.0F};           // unit: emission of flat lights and the sun; along tubes
    float width_direction[3] = {1.0F, 0.0F, 0.0F}; // ellipse, rectangle: unit, perpendicular to the axis
    float width = 0.0F;                            // ellipse, rectangle [m], along width_direction
    float height = 0.0F;                           // ellipse, rectangle [m], across it
    float length = 0.0F;                           // cylinder, tube without its hemispherical ends [m]
    bool two_sided = false;                        // flat lights: emit to both sides, the luminance on each
};

// A coat of coat.hpp, as constants_of() of coated.hpp creates it.
struct CoatConstants {
    static constexpr std::size_t most_numbers = 33;

    bool is_on = false;
    CoatOrder order = CoatOrder::physical;
    float numbers[most_numbers] = {};
};

// A material of brdf.hpp, as constants_of() there creates it, with the coat over it if there is one.
struct MaterialConstants {
    static constexpr std::size_t most_numbers = 24;

    enum class Kind : std::uint8_t {}; // kind_of<Lambert> … of brdf.hpp

    Kind kind{};
    float numbers[most_numbers] = {}; // the numbers of its struct, in their order
    CoatConstants coat;
};

// Methods of other renderers for the irradiance of area lights, kept for comparison (irradiance_sphere_named.hpp,
// irradiance_named.hpp). `ue4` has a separate form for the tube only; for the other shapes it equals `point`.
enum class Approximation : std::uint8_t { point, frostbite, ue4 };

struct Kernels {
    simd::InstructionSet set;
    const char* name; // of the instruction set
    std::size_t lanes;

    // Outgoing luminance [nt] of the three channels towards the eye, one per surface point; `rgb` is overwritten and
    // must not overlap the input.
    void (*shade)(const Surfaces&, const LightConstants&, const MaterialConstants&, float* const rgb[3]);

    // Illuminance [lx], one per surface point: of `intensity_cd` for a punctual light, of a luminance of 1 nt (that is,
    // E/L in sr, times the window) for an area light or a sun. Receivers are sorted by their horizon before they are
    // packed, so `lx` must not overlap the input.
    void (*irradiance)(const Surfaces&, const LightConstants&, float* lx);

    // The same by an approximation, of one side; 0 for a punctual light, the value of `point` for a sun. May exceed π.
    void (*approximate_irradiance)(const Surfaces&, const LightConstants&, Approximation, float* lx);
};

// The kernels of `set`, or the scalar ones where simd::available(set) is false.
const Kernels& kernels(simd::InstructionSet set);

} // namespace gonio::shading
