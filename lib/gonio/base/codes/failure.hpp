// Diagnostic codes of failures that are not about one photometric file or rig: every Error has one of them, or one of
// the other tables. The family tells the Failure, and with it the exit status; the first code of a family is the
// general one. A code is of a class of mistakes: many sentences share it.
#pragma once

#include <gonio/base/diagnostic_codes.hpp>

#include <array>

namespace gonio {

inline constexpr auto failure_codes = std::to_array<DiagnosticCode>({
    {"USE0101", Severity::error, Strict::same, "request that has no answer",
     "The words are understood, and what they ask for does not exist: the luminance of a point, a flux of the sun, a "
     "picture of nothing. The message says what stands in the way, the hint what to ask instead."},
    {"USE0102", Severity::error, Strict::same, "unknown option",
     "The command has no such option. 'gonio COMMAND --help' lists those it has."},
    {"USE0103", Severity::error, Strict::same, "unknown name",
     "A command, shape, unit, layout, stage, key or another of a closed set was named, and there is none of that name. "
     "Names are written in lower case. The hint has the nearest one; 'gonio list' shows the sets."},
    {"USE0104", Severity::error, Strict::same, "something is missing",
     "An option, a key or a command needs a value, an input, an output or another option beside it, and none is "
     "given."},
    {"USE0105", Severity::error, Strict::same, "value of the wrong form",
     "The text is not what is expected there: a number, an amount with its unit, a size, three coordinates, a list. "
     "The hint shows one that would do."},
    {"USE0106", Severity::error, Strict::same, "value out of range",
     "The value is understood and lies outside what can be computed or what is allowed there. Nothing is clamped. "
     "'gonio list limits' shows the limits on sizes and counts."},
    {"USE0107", Severity::error, Strict::same, "options that exclude each other",
     "Two options, keys or inputs say the same thing twice or contradict each other, or one has no use beside the "
     "other. Leave one of them out."},
    {"USE0108", Severity::error, Strict::same, "files that conflict",
     "An output would replace an input, another output, or a file that exists. An input is never replaced; existing "
     "files in a folder are replaced with --overwrite, or with -u where they are out of date."},

    {"FIL0101", Severity::error, Strict::same, "file that cannot be used",
     "A file or folder is not there, or it is not of the kind that is needed: a folder instead of a file, a file "
     "instead of a folder."},
    {"FIL0102", Severity::error, Strict::same, "file that cannot be read",
     "The operating system refused to open or to read it. The message has its reason."},
    {"FIL0103", Severity::error, Strict::same, "file that cannot be written",
     "The operating system refused to make, write or rename it. The message has its reason. A "
     "file that was there before is left as it was."},
    {"FIL0104", Severity::error, Strict::same, "file larger than its limit",
     "Files are read up to a size that is far above what such a file needs. 'gonio list limits' shows it."},
    {"FIL0105", Severity::error, Strict::same, "file outside the folder",
     "An input names another file that lies outside its own folder or is not a regular file. An input of somebody else "
     "must not name what it likes. An option of the command lets a rig name other files."},

    {"INP0101", Severity::error, Strict::same, "input that is not what it should be",
     "A table, a spectrum, a picture, a manifest or another input is broken or lacks something. The message has the "
     "place where it is known."},

    {"UNS0101", Severity::error, Strict::same, "not supported",
     "The input is fine, and gonio cannot do this with it, or the target has no way to say it."},
    {"UNS0102", Severity::error, Strict::same, "module that cannot be loaded",
     "Pictures and colour configurations are handled by modules that are loaded when they are needed first. This one "
     "or a library that it needs is not there, or it is of another version of gonio."},
    {"UNS0103", Severity::error, Strict::same, "out of memory",
     "The process may not have the memory that this needs. What was written so far is whole."},

    {"INT0101", Severity::error, Strict::same, "internal error",
     "This is a bug of gonio: please report it with the command and its input."},
});
static_assert(in_order(failure_codes));

} // namespace gonio
