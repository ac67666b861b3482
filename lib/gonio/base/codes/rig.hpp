// Diagnostic codes of rig files: those that reading gonio.rig/1 may emit. An error in a profile that a rig names keeps
// its own code, and so does a file that cannot be read.
#pragma once

#include <gonio/base/diagnostic_codes.hpp>

#include <array>

namespace gonio {

inline constexpr auto rig_codes = std::to_array<DiagnosticCode>({
    {"RIG0101", Severity::error, Strict::same, "not a rig",
     "The text is not JSON, or it is JSON of another kind. A rig is an object that begins with its schema: { "
     "\"schema\": \"gonio.rig/1\", \"lights\": [ … ] }."},
    {"RIG0102", Severity::error, Strict::same, "another version of the schema",
     "The rig names a schema other than gonio.rig/1, which is the only one."},
    {"RIG0103", Severity::error, Strict::same, "unknown name in a rig",
     "A key, or a name in a value, does not exist. The hint shows the nearest name and the whole list."},
    {"RIG0104", Severity::error, Strict::same, "key missing in a rig",
     "An object of the rig lacks a required key, for example the shape of a light or the name of a surface."},
    {"RIG0105", Severity::error, Strict::same, "value of the wrong type in a rig",
     "The value has another type than expected: string, number, array or object. Amounts are strings because they "
     "carry their unit; positions and directions are arrays of three numbers."},
    {"RIG0106", Severity::error, Strict::same, "invalid value in a rig",
     "The value has the right type, but it is not understood, is out of range, or contradicts another value. The "
     "text of a shape, colour or material follows the same rules as on the command line."},
    {"RIG0107", Severity::error, Strict::same, "given twice in a rig",
     "An object has the same key twice, or two keys of which only one is allowed."},
    {"RIG0108", Severity::error, Strict::same, "rig beyond a limit",
     "The rig has more lights or surfaces than gonio allows, or a light has too many values or is nested too "
     "deep. 'gonio list limits' shows the limits."},
});
static_assert(in_order(rig_codes));

using RigCode = CodeOf<rig_codes>;

} // namespace gonio
