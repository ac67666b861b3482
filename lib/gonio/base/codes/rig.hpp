// Diagnostic codes of rig files: what reading gonio.rig/1 may emit. What is wrong in a profile that a rig names keeps
// its own code, and so does a file that cannot be read.
#pragma once

#include <gonio/base/diagnostic_codes.hpp>

#include <array>

namespace gonio {

inline constexpr auto rig_codes = std::to_array<DiagnosticCode>({
    {"RIG0101", Severity::error, Strict::same, "not a rig",
     "The text is not JSON, or it is JSON of something else. A rig is an object that begins with its schema: "
     "{ \"schema\": \"gonio.rig/1\", \"lights\": [ … ] }."},
    {"RIG0102", Severity::error, Strict::same, "another version of the schema",
     "The rig says that it is of another schema than gonio.rig/1, the only one there is."},
    {"RIG0103", Severity::error, Strict::same, "unknown name in a rig",
     "A key, or a name in a value, is not one of those that exist. The hint has the nearest one and all there are."},
    {"RIG0104", Severity::error, Strict::same, "key missing in a rig",
     "An object of the rig lacks a key that it must have: a light its shape, a surface its name."},
    {"RIG0105", Severity::error, Strict::same, "value of the wrong type in a rig",
     "A string, a number, an array or an object stands where another of them is expected. Amounts are strings, because "
     "they carry their unit; positions and directions are arrays of three numbers."},
    {"RIG0106", Severity::error, Strict::same, "value that does not fit in a rig",
     "The value has the right type and is not understood, out of range, or contradicts another one. The text of a "
     "shape, a colour or a material is refused for the same reasons as on a command line."},
    {"RIG0107", Severity::error, Strict::same, "given twice in a rig",
     "A key is there twice in one object, or an object has two keys of which it may have one."},
    {"RIG0108", Severity::error, Strict::same, "rig beyond a limit",
     "A rig holds more lights or surfaces, or one light holds more values or is nested deeper, than gonio takes. "
     "'gonio list limits' shows the limits."},
});
static_assert(in_order(rig_codes));

using RigCode = CodeOf<rig_codes>;

} // namespace gonio
