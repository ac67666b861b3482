// What to type into a program so that it shows a light: the fields of its light, their values and units.
//
// Policies (gonio/light/policy.hpp) tell what a number becomes in a program; this is the other question. The amount is
// the number with which the program emits the flux of the light, in the unit that its users see first.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/photometry.hpp>
#include <gonio/light/policy.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace gonio {

struct ProgramField {
    std::string name;  // as the program names it: "Intensity"
    std::string value; // "800", "3", "Lumens"
    std::string unit;  // "lm", "cm", "deg"; empty for a word or a share
};

struct ProgramLight {
    std::string light; // the program's kind: "Point Light"
    std::vector<ProgramField> fields;
    std::string note; // how the program's light differs; often empty
};

// The programs that have fields, in the order of policies().
std::vector<const Policy*> programs_with_fields();

// A sphere becomes the point of the same flux where a program has no spheres. Fails (unsupported) where the program has
// no such light, and as express() does.
Result<ProgramLight> program_light(const Policy& program, const Shape& shape, const Emission& emission);

} // namespace gonio
