// Diagnostic codes of failures that do not concern one photometric file or rig: every Error has one of these, or one
// from the other tables. The family determines the Failure, and with it the exit status; the first code of a family is
// the general one. A code covers a class of mistakes: many messages share it.
#pragma once

#include <gonio/base/diagnostic_codes.hpp>

#include <array>

#pragma GCC visibility push(default)
namespace gonio {

// The codes of failures, by class.
inline constexpr auto failure_codes = std::to_array<DiagnosticCode>({
    {"USE0101", Severity::error, Strict::same, "request without an answer",
     "The request is understood, but its result is not defined: the luminance of a point, the flux of a sun. The "
     "message states the reason, and the hint shows what to ask instead."},
    {"USE0102", Severity::error, Strict::same, "unknown option",
     "The command does not have this option. 'gonio COMMAND --help' lists its options."},
    {"USE0103", Severity::error, Strict::same, "unknown name",
     "The name of a command, shape, unit, layout, stage, key or other item does not exist. Names are lower case. "
     "The hint shows the nearest name; 'gonio list' shows all lists."},
    {"USE0104", Severity::error, Strict::same, "something is missing",
     "An option, key or command needs a value, an input, an output or another option that was not given."},
    {"USE0105", Severity::error, Strict::same, "value of the wrong form",
     "The text does not have the expected form: a number, an amount with its unit, a size, three coordinates, a "
     "list. The hint shows an example."},
    {"USE0106", Severity::error, Strict::same, "value out of range",
     "The value is understood, but it is outside the allowed range. gonio does not clamp it. 'gonio list limits' "
     "shows the limits of sizes and counts."},
    {"USE0107", Severity::error, Strict::same, "options that cannot be combined",
     "Two options, keys or inputs contradict each other, mean the same, or one has no effect next to the other. "
     "Leave one of them out."},
    {"USE0108", Severity::error, Strict::same, "files that conflict",
     "An output would replace an input, another output, or an existing file. Inputs are never replaced. Existing "
     "files in a folder are replaced with --overwrite, or with -u if they are outdated."},

    {"FIL0101", Severity::error, Strict::same, "file that cannot be used",
     "A file or folder does not exist or has the wrong kind: a folder instead of a file, or a file instead of a "
     "folder."},
    {"FIL0102", Severity::error, Strict::same, "file that cannot be read",
     "The operating system refused to open or read the file. The message states its reason."},
    {"FIL0103", Severity::error, Strict::same, "file that cannot be written",
     "The operating system refused to create, write or rename the file. The message states its reason. An "
     "existing file is left as it was."},
    {"FIL0104", Severity::error, Strict::same, "file larger than its limit",
     "The file is larger than gonio reads. The limit is far above the size of such files; 'gonio list limits' "
     "shows it."},
    {"FIL0105", Severity::error, Strict::same, "file outside the folder",
     "An input names another file that is outside the folder of the input or is not a regular file. This protects "
     "you from files of other people. An option of the command allows it for rigs."},
    {"FIL0106", Severity::error, Strict::same, "threads that cannot be started",
     "The operating system refused to start the threads that a library needs: the limit on processes or memory is too "
     "low."},

    {"INP0101", Severity::error, Strict::same, "invalid input",
     "A table, spectrum, picture, manifest or other input is broken or incomplete. The message states the place "
     "if it is known."},

    {"UNS0101", Severity::error, Strict::same, "not supported",
     "The input is valid, but gonio or the target cannot represent it."},
    {"UNS0102", Severity::error, Strict::same, "module that cannot be loaded",
     "Modules for pictures and colour configurations are loaded when they are first needed. This module or a "
     "library that it needs is missing, or it belongs to another version of gonio."},
    {"UNS0103", Severity::error, Strict::same, "out of memory",
     "The process does not have the memory that this needs. Files written so far are complete."},
    {"UNS0104", Severity::error, Strict::same, "radiometric profile",
     "The profile states that its intensities are not candela (WEB0110), so it has no lumens, lux or nits. "
     "--as-candela takes its numbers as candela; 'gonio edit FILE --as-candela' writes a profile that says so."},
    {"UNS0105", Severity::error, Strict::same, "fonts that are missing",
     "A PDF contains the letters of its text, from DejaVu Sans and DejaVu Sans Bold. The message states where they "
     "were "
     "looked for; Debian's package fonts-dejavu-core has them, and --fonts names another folder."},

    {"INT0101", Severity::error, Strict::same, "internal error",
     "This is a bug in gonio. Please report it with the command and its input."},
});
static_assert(in_order(failure_codes));

} // namespace gonio
#pragma GCC visibility pop
