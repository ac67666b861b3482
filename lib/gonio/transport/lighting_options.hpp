// How the light of a scene is computed: what pictures and probes have in common.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/simd/dispatch.hpp>
#include <gonio/sky/sky.hpp>
#include <gonio/transport/surroundings_method.hpp>

#include <cstdint>
#include <limits>
#include <memory>

#pragma GCC visibility push(default)
namespace gonio {

struct LocalProbe;

// Which shadows surfaces cast.
enum class Shadows : std::uint8_t {
    off,
    hard, // every light as a point at its centre
    soft, // by the light's size and shape; for the sun, its disk
};

// LightingOptions::bounces: until the light is absorbed.
inline constexpr int all_bounces = std::numeric_limits<int>::max();

// How the light on a stage is computed.
struct LightingOptions {
    // exact: irradiance in closed form, highlights as by ltc; reference: everything by quadrature, a millisecond for
    // each light with a size and each point. frostbite, ue4 and point use the irradiance of those renderers and the
    // highlights that go with it (README.md).
    IrradianceMethod method = IrradianceMethod::exact;
    ReferenceGoal goal; // of `reference`
    Shadows shadows = Shadows::soft;
    Sky sky; // without its sun, which is a light
    SurroundingsMethod surroundings = SurroundingsMethod::exact;
    std::shared_ptr<const LocalProbe> probe; // of the methods that need one (has_local_probe())
    int bounces = 0;          // between the surfaces of the stage: 0 = direct light alone, or all_bounces
    bool specular = true;     // false: only what the materials' diffuse parts scatter, and the lights themselves
    bool illuminance = false; // computes the illuminance of the surfaces too
    unsigned threads = 0;     // 0 = as many as the machine has
    // Results of different instruction sets agree to 1e-4 of the greatest luminance.
    simd::InstructionSet instruction_set = simd::best_available();
};

} // namespace gonio
#pragma GCC visibility pop
