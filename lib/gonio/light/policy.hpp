// Policies: what other programs mean by a photometric number.
//
// Programs disagree about the same number: a spot of 800 lm has 800/π, 800/4π or 800/2π(1 − cos b) candela on its axis,
// and none of these gives the flux that its lobe emits. A policy states, for each shape and unit, which share of the
// flux that the number promises is emitted in that program; everything after that is photometry
// (gonio/light/photometry.hpp). A unit that a program does not use keeps its physical meaning, so that `800lm` can be
// converted to a program's watts.
//
// What each program does was read from its source or documentation, which each policy names; versions change.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/photometry.hpp>

#include <span>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// A program whose units differ from the physical ones, as `gonio list policies` shows it.
struct Policy {
    std::string_view name; // "unity-hdrp"
    std::string_view summary;
    std::string_view source;
};

// "physical" comes first.
std::span<const Policy> policies();

// Fails (usage) on an unknown name and suggests the nearest.
Result<const Policy*> find_policy(std::string_view name);

// A shape as the program shows it.
struct ProgramShape {
    Shape shape;
    std::string note; // "its lobe is smoothstep-cos"; empty if the shape is the same
};

// Spots get the lobe that the program has, other shapes stay as they are. Hard spots stay hard.
ProgramShape program_shape(const Policy& policy, Shape shape);

// How a policy interprets a unit for one shape.
struct PolicyMeaning {
    bool own = false;                 // whether the program uses this unit; if not, it keeps its physical meaning
    double emitted_over_said = 1.0;   // the flux that is emitted over the flux that the number promises
    double luminance_at_ev_0 = 0.125; // nt; the luminance at an exposure value of 0
    std::string formula;              // the program's: "I = Φ/π"
    std::string note;                 // other differences; often empty
};

// Profiles and masks must be loaded. Fails (unsupported) where the program has no such light.
Result<PolicyMeaning> policy_meaning(const Policy& policy, const Shape& shape, Dimension dimension);

// The physical value that emits as much as `value` does in the program.
PhotometricValue physical_value(const PolicyMeaning& meaning, PhotometricValue value);

// The number to write in the program, in `unit`, for a physical amount of `number` in `unit`.
double policy_number(const PolicyMeaning& meaning, const PhotometricUnit& unit, double number);

} // namespace gonio
#pragma GCC visibility pop
